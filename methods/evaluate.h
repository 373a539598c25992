/* evaluate.h - evaluates the hand methods for a room: sums over openings, corrections,
 * pairs of methods, averages.
 *
 * A method gives the components of one opening (method.h). Here each method is run for
 * each receiver: method_run.h calls it for each opening, applies the corrections for
 * glass, frame and dirt that its figures lack (allowance.h), and adds the openings up.
 * Pairs of methods become daylight factors:
 *
 *     df(A+B) = sc(A) + erc(A) + irc(B)
 *
 * An opening that a method does not cover makes the method's value at that receiver
 * NAN, and `why` names the opening. An internally reflected component that is an
 * average of the room is used for each point of the room.
 *
 * For a method that gives values at points, the average over the working plane is the
 * mean reading of receivers that face up. The mean is an integral over directions if
 * the method has one (pp_method.average), and otherwise an adaptive cubature
 * (method_run.h). A method with its own average (has_average) gives its own.
 */
#ifndef PP_METHODS_EVALUATE_H
#define PP_METHODS_EVALUATE_H

#include "model/base/error.h"
#include "model/results/report.h"

/* Adds the columns of a selection of methods (selection.h) to `report`, whose world,
 * light, receivers and receiver_count the caller has set. A column that the report
 * already has is left unchanged. A wrong selection is PP_BAD_INPUT. On failure some
 * columns may have been added; pp_report_clear frees them. The points are divided among
 * report->threads threads; the results do not depend on the number of threads.
 *
 * With report->explain the readings of each point (and, for methods that give room
 * averages, of the average) have the steps of their sum: for each opening the method's
 * own steps (ending in sc, erc, irc or df), then the corrections factor by factor,
 * `SC_1 = sc M G B`, then the sum, `SC = SC_1 + SC_2` (with one opening `SC = sc M G
 * B`), and `DF = SC + ERC + IRC`. The steps of the externally reflected component are
 * listed with those of the sky component. */
enum pp_status pp_methods_evaluate(struct pp_report *report, const char *selection,
                                   struct pp_error *err);

#endif
