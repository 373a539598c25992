/* fuzz_formula.c - the sum of a formula (--formula) with any bytes is parsed, or
 * rejected with a column and a reason; a parsed sum can be evaluated.
 *
 * For clang's libFuzzer (make fuzz).
 */
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "model/expression/expression_value.h"
#include "model/results/formula.h"
#include "tests/fuzz/must.h"

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t length)
{
    static const struct pp_formula_quantity quantities[] = {
        {"W", PP_UNIT_SQUARE_METRE, "area of glass"},
        {"A", PP_UNIT_SQUARE_METRE, "area of all surfaces"},
        {"R_fw", PP_UNIT_NUMBER, "reflectance"},
        {"theta", PP_UNIT_ANGLE, "angle of the sky"},
        {0}};
    static const struct pp_formula formula = {.symbol = "irc",
                                              .sum = "0.85 W / A",
                                              .unit = PP_UNIT_DAYLIGHT_FACTOR,
                                              .what = "a component",
                                              .quantities = quantities};
    static const double values[] = {2.0, 60.0, 0.5, 1.1};
    struct pp_expression expression;
    struct pp_expression_mistake mistake = {0};
    char *text = strndup((const char *)bytes, length);
    must(text != NULL);
    if (pp_formula_parse(&expression, &formula, text, 0, &mistake)) {
        pp_formula_comes_out(&formula, &expression);
        struct pp_expression_fault fault;
        pp_expression_value(&expression, values, &fault);
    } else {
        must(mistake.what[0] != '\0' && mistake.column >= 0
             && (size_t)mistake.column <= strlen(text));
    }
    free(text);
    return 0;
}
