/* evaluate.h - the hand methods at work: sums over openings, allowances, pairs,
 * averages.
 *
 * A method says what one opening gives. Here it is asked for each opening and each
 * receiver, what its figures lack of glass, frame and dirt is multiplied on
 * (methods/allowance.h), and the parts are put together:
 *
 *     df(A+B) = sc(A) + erc(A) + irc(B)
 *
 * One opening that a method does not cover makes its value at that receiver NAN, and
 * `why` names the opening. An internally reflected component that is an average of the
 * room stands for each of its points.
 *
 * Averages over the working plane of methods that speak for a point are the integral of
 * what receivers facing up would read over the plane's area, by adaptive cubature to a
 * relative estimated error of PP_AVERAGE_ERROR (of methods that count, whose readings
 * are no finer, PP_AVERAGE_ERROR_COUNTS), with at most PP_AVERAGE_POINTS points. A method
 * that has an average of its own (has_average) gives that.
 */
#ifndef PP_METHODS_EVALUATE_H
#define PP_METHODS_EVALUATE_H

#include "model/base/error.h"
#include "model/results/report.h"

#define PP_AVERAGE_ERROR 1e-3
#define PP_AVERAGE_ERROR_COUNTS 1e-2
enum { PP_AVERAGE_POINTS = 2000 };

/* With report->explain each point's readings (of methods that speak for the room: the
 * average's too) have the steps of their sum, each opening as the method has it (sc,
 * erc, irc or df in formulae) and then with its allowances settled, factor by factor,
 * `SC_1 = sc M G B`, and what they come to, `SC = SC_1 + SC_2` (of one opening at once
 * `SC = sc M G B`), `DF = SC + ERC + IRC`. The externally reflected component's are
 * those of the sky component.
 *
 * Adds to `report`, of which the caller has set world, receivers and receiver_count,
 * the columns of a selection, a list separated by commas of
 *
 *     default   exact+bre, brs-table+bre, average-df; the same as NULL
 *     all       every direct method with bre, exact with every internal one, all whole
 *     A+B       direct component by A, internally reflected by B, their components too
 *     NAME      one method, with the components that it gives
 *
 * A column that is there already is left as it is. A selection that makes no sense is
 * PP_BAD_INPUT. On failure some columns may stand; pp_report_clear frees them. The
 * points are dealt out to OpenMP's threads; the numbers do not depend on how many. */
enum pp_status pp_methods_evaluate(struct pp_report *report, const char *selection,
                                   struct pp_error *err);

/* Does the selection make sense? PP_BAD_INPUT, with the known names and the nearest
 * one, where it does not. */
enum pp_status pp_selection_check(const char *selection, struct pp_error *err);

#endif
