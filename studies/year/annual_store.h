/* annual_store.h - the origin of a room's coefficients, by which stored ones are
 * recognised. */
#ifndef PP_STUDIES_YEAR_ANNUAL_STORE_H
#define PP_STUDIES_YEAR_ANNUAL_STORE_H

#include "studies/year/annual_work.h"

/* Sets the stores of the options, and the origin of the coefficients of a state, except
 * for its number of paths. *samples: paths per point, as in pp_annual_options; it
 * becomes that of a store to read. PP_BAD_INPUT if a store has the room and state with
 * another origin, or if a store to read does not have all randomisations. */
enum pp_status pp_annual_store_begin(struct pp_year_stores *stores,
                                     const struct pp_annual_work *work,
                                     const struct pp_annual_state *state, int *samples,
                                     struct pp_error *err);

/* Writes the origin as lines "NAME=value" for the head of a matrix. */
void pp_annual_store_record(char *text, size_t room,
                            const struct pp_year_origin *origin);

#endif
