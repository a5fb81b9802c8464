"""C++, Julia and MATLAB as Python: their syntax trees, printed line by line."""
