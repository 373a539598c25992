/* year_product.h - coefficients times light: the illuminances of many hours. */
#ifndef PP_SIMULATE_YEAR_YEAR_PRODUCT_H
#define PP_SIMULATE_YEAR_YEAR_PRODUCT_H

#include "simulate/year/light_columns.h"

/* out[row][hour] = sum over columns of rows[row][column] x light. out has tiles x
 * PP_LIGHT_LANES numbers per row. */
void pp_year_product(float *out, const float *rows, int row_count,
                     const struct pp_light_columns *light);

#endif
