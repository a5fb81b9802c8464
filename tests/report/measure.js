// Measures the page in the frame and writes what it found into the document around it.

function luminance(colour) {
  const [r, g, b] = colour
    .map(v => v / 255)
    .map(v => (v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4));
  return 0.2126 * r + 0.7152 * g + 0.0722 * b;
}

function style(node) {
  return node.ownerDocument.defaultView.getComputedStyle(node);
}

function channels(text) {
  return text.match(/[\d.]+/g).map(Number);
}

function background(node) {
  for (let e = node; e; e = e.parentElement) {
    const colour = channels(style(e).backgroundColor);
    if (colour.length === 3 || colour[3] === 1) return colour.slice(0, 3);
  }
  return [255, 255, 255];
}

// The contrast ratio of WCAG 2: 4.5 is asked for text.
function contrast(node) {
  const two = [channels(style(node).color).slice(0, 3), background(node)].map(luminance);
  return (Math.max(...two) + 0.05) / (Math.min(...two) + 0.05);
}

function named(node) {
  return `${node.tagName}.${node.getAttribute("class") || ""} ${node.textContent.slice(0, 60)}`;
}

// Elements that reach over the right edge and are not inside a box that scrolls or clips by itself.
function outside(page, width) {
  return [...page.body.querySelectorAll("*")].filter(node => {
    const box = node.getBoundingClientRect();
    const held = node.parentElement.closest(".terms, .wide, svg, thead");
    return box.width > 0 && box.right > width + 1 && !held;
  });
}

// Tables that are wider than what they stand in; a matrix of routes is seen whole, without a scroll.
function wide(page) {
  return [...page.querySelectorAll("table")].filter(
    node =>
      (!node.closest(".wide") || node.matches(".matrix")) &&
      node.offsetWidth > node.parentElement.clientWidth + 1,
  );
}

function measure(frame) {
  const page = frame.contentDocument;
  const root = page.documentElement;
  for (const fold of page.querySelectorAll("details")) fold.open = true;
  const texts =
    "p, h1, h2, h3, h4, h5, th, td, dd, li, summary, code, .chip, .note, .bound, .label, .wrong, .right";
  const faint = [...page.querySelectorAll(texts)].filter(
    node => node.textContent.trim() && contrast(node) < 4.5,
  );
  return {
    width: root.clientWidth,
    scroll: root.scrollWidth,
    height: root.scrollHeight,
    dark: frame.contentWindow.matchMedia("(prefers-color-scheme: dark)").matches,
    fetched: frame.contentWindow.performance.getEntriesByType("resource").map(e => e.name),
    marked: page.querySelectorAll("mrow.wrong, mrow.right").length,
    maths: page.querySelectorAll("math").length,
    outside: outside(page, root.clientWidth).slice(0, 5).map(named),
    wide: wide(page).slice(0, 5).map(named),
    faint: faint.slice(0, 5).map(named),
  };
}

addEventListener("load", () => {
  const found = measure(document.querySelector("iframe"));
  document.getElementById("found").textContent = JSON.stringify(found);
});
