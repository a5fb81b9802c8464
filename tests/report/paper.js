// Measures the page in the frame under its rules for paper.

function style(node) {
  return node.ownerDocument.defaultView.getComputedStyle(node);
}

function named(node) {
  return `${node.tagName}.${node.getAttribute("class") || ""} ${node.textContent.slice(0, 60)}`;
}

function forPaper(page) {
  for (const sheet of page.styleSheets)
    for (const rule of sheet.cssRules)
      if (rule.media && /\bprint\b/.test(rule.media.mediaText)) rule.media.mediaText = "all";
}

// What scrolls or is cut on a screen is lost on paper.
function cut(node) {
  const { overflowX, overflowY } = style(node);
  return (
    (overflowX !== "visible" && node.scrollWidth > node.clientWidth + 1) ||
    (overflowY !== "visible" && node.scrollHeight > node.clientHeight + 1)
  );
}

addEventListener("load", () => {
  const page = document.querySelector("iframe").contentDocument;
  forPaper(page);
  const every = [...page.body.querySelectorAll("*")].filter(
    node => node.getClientRects().length && !node.closest(".unseen"),
  );
  const right = page.documentElement.clientWidth;
  const found = {
    heading: page.querySelector("h1").getBoundingClientRect().height,
    stuck: every.filter(node => ["sticky", "fixed"].includes(style(node).position)).map(named),
    cut: every.filter(node => !node.closest("svg, math") && cut(node)).map(named),
    outside: every
      .filter(node => !node.closest("svg") && node.getBoundingClientRect().right > right + 1)
      .map(named),
    moving: every.filter(node => node.matches(".moving")).length,
    still: every.filter(node => node.matches(".still")).length,
    strips: page.querySelectorAll(".still").length,
    animated: page.getAnimations().length,
  };
  document.getElementById("found").textContent = JSON.stringify(found);
});
