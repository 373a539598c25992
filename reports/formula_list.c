/* formula_list.c - prints all methods and their formulae. */
#include "reports/formula_list.h"

#include <string.h>

#include "methods/method.h"
#include "reports/parts/print.h"

static const char *const units[] = {
    [PP_UNIT_DAYLIGHT_FACTOR] = "%",
    [PP_UNIT_NUMBER] = "-",
    [PP_UNIT_COUNT] = "-",
    [PP_UNIT_ANGLE] = "deg",
    [PP_UNIT_METRE] = "m",
    [PP_UNIT_SQUARE_METRE] = "m2",
    [PP_UNIT_LUX] = "lx",
};

static void print_formula(const struct pp_formula *formula, FILE *out)
{
    fprintf(out, "  %s = %s%s%s%s\n", formula->symbol, formula->sum,
            formula->source ? "  [" : "", formula->source ? formula->source : "",
            formula->source ? "]" : "");
    fprintf(out, "      %-8s%-5s%s%s\n", formula->symbol, units[formula->unit],
            formula->what, formula->fixed ? "; fixed" : "");
    const struct pp_formula_quantity *quantity = formula->quantities;
    for (; !formula->fixed && quantity->symbol; quantity++)
        fprintf(out, "      %-8s%-5s%s\n", quantity->symbol, units[quantity->unit],
                quantity->what);
}

void pp_formula_list(FILE *out)
{
    char text[512] = "Functions: ";
    const char *const *functions = pp_expression_functions();
    for (int i = 0; functions[i]; i++) {
        strcat(text, functions[i]);
        strcat(text, functions[i + 1] ? ", " : ", with angles in degrees; and pi.");
    }
    fputs("Formulae that --formula 'METHOD: SYMBOL = ...' can replace, with their "
          "symbols:\n",
          out);
    pp_print_wrapped(text, 0, 0, 80, out);
    for (int i = 0; pp_methods[i]; i++) {
        const struct pp_method *method = pp_methods[i];
        if (!method->formulae)
            continue;
        fprintf(out, "\n%s  [%s] %s\n", method->name, method->source, method->summary);
        for (int k = 0; method->formulae[k]; k++)
            print_formula(method->formulae[k], out);
    }
}

void pp_formula_list_variants(const struct pp_variant_list *variants, int width,
                              FILE *out)
{
    for (int i = 0; variants && i < variants->count; i++) {
        const struct pp_variant *variant = &variants->list[i];
        char text[sizeof variant->formula.sum + 128];
        snprintf(text, sizeof text, "%s: %s with %s = %s", variant->name,
                 variant->method->name, variant->formula.symbol, variant->formula.sum);
        fputs(i == 0 ? "\n  " : "  ", out);
        pp_print_wrapped(text, 2, 4, width, out);
    }
}
