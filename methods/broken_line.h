/* broken_line.h - reading a published table between its rows, as a straight-edge does.
 */
#ifndef PP_METHODS_BROKEN_LINE_H
#define PP_METHODS_BROKEN_LINE_H

/* The value at x of the line through `count` (2 or more) rows {x, y}, x ascending;
 * the first row's before it, the last row's beyond. */
double pp_broken_line(const double (*rows)[2], int count, double x);

/* Between which rows x lies: the index of the upper one, 1 to count - 1, and in *share
 * how far x is from the lower to the upper, 0 to 1; x outside is taken at the nearer
 * end. `column` is x's place in rows `width` numbers wide. */
int pp_broken_line_place(const double *rows, int count, int width, int column, double x,
                         double *share);

#endif
