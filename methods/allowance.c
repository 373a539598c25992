/* allowance.c - the corrections for glass, dirt, frame and curtains: as factors, as
 * steps and as text. */
#include "methods/allowance.h"

#include <assert.h>
#include <stdarg.h>
#include <stdio.h>

#include "methods/method.h"
#include "model/base/text.h"
#include "model/light/slats/blind.h"

/* Factor G: diffuse transmittance divided by that of clear single glass. */
static double glass_type(const struct pp_glass *glass)
{
    return glass->diffuse / pp_glass_clear_single().diffuse;
}

double pp_allowance_reflected_glass(const struct pp_opening *opening)
{
    if (opening->glass.panes == 0)
        return 1.0;
    return PP_ALLOWANCE_CLEAR_DIFFUSE * glass_type(&opening->glass);
}

static const struct pp_formula_quantity of_the_opening[] = {
    {"a", PP_UNIT_SQUARE_METRE, "area of the opening"},
    {"B", PP_UNIT_NUMBER, "frame factor: ratio of glass area to opening area"},
    {0},
};

#define NET_GLASS                                                                      \
    .sum = "a B", .unit = PP_UNIT_SQUARE_METRE, .source = "BRE310",                    \
    .what = "net glass area", .quantities = of_the_opening, .fixed = true

const struct pp_formula pp_allowance_glass_W = {.symbol = "W", NET_GLASS};
const struct pp_formula pp_allowance_glass_Ag = {.symbol = "Ag", NET_GLASS};

double pp_allowance_net_glass_m2(const struct pp_opening *opening)
{
    const double values[] = {opening->inner.area_m2, opening->frame_factor};
    return pp_formula_value(&pp_allowance_glass_W, values);
}

double pp_allowance_net_glass(struct pp_worksheet *sheet,
                              const struct pp_formula *formula,
                              const struct pp_opening *opening)
{
    double a = opening->inner.area_m2, B = opening->frame_factor;
    if (B == 1.0) {
        pp_worksheet_put(sheet, PP_UNIT_SQUARE_METRE, a, formula->symbol,
                         "net glass area (the whole opening, because there is no "
                         "frame)");
        return a;
    }
    pp_worksheet_put(sheet, PP_UNIT_SQUARE_METRE, a, "a", "area of the opening");
    pp_allowance_put(sheet, PP_ALLOWS_FRAME, opening, "B", "frame factor");
    return pp_worksheet_work(sheet, formula, "net glass area");
}

/* ---- corrections ---- */

struct correction {
    const char *symbol, *what;
    double value;
};

enum { CORRECTIONS_MOST = 8 };

/* Sets *correction to the correction for glass. Returns false if figures with these
 * allowances need no such correction. */
static bool correct_glass(struct correction *correction, unsigned allowances,
                          const struct pp_opening *opening)
{
    if (allowances & PP_ALLOWS_OWN_GLASS)
        return false;
    bool bare = opening->glass.panes == 0;
    if (bare && allowances & PP_ALLOWS_NO_GLASS)
        return false;
    if (!(allowances & PP_ALLOWS_CLEAR_GLASS))
        *correction = (struct correction){
            "T", "diffuse transmittance of the glass (clear single glass: 0.85)",
            pp_allowance_reflected_glass(opening)};
    else if (bare)
        *correction = (struct correction){"G",
                                          "factor for an opening without glass: 1 / "
                                          "0.85, relative to clear single glass",
                                          1.0 / PP_ALLOWANCE_CLEAR_DIFFUSE};
    else
        *correction = (struct correction){
            "G", "diffuse transmittance of the glass, relative to clear single glass",
            glass_type(&opening->glass)};
    return true;
}

/* Lists the corrections that figures with these allowances lack; returns their
 * number. */
static int correct(struct correction list[CORRECTIONS_MOST], unsigned allowances,
                   const struct pp_opening *opening)
{
    int count = 0;
    if (!(allowances & PP_ALLOWS_DIRT))
        list[count++] =
            (struct correction){"M", "maintenance factor (dirt)", opening->maintenance};
    count += correct_glass(&list[count], allowances, opening);
    if (!(allowances & PP_ALLOWS_FRAME))
        list[count++] = (struct correction){
            "B", "frame factor: ratio of glass area to opening area",
            opening->frame_factor};
    /* No published figure includes curtains. */
    if (opening->curtains != 1.0)
        list[count++] = (struct correction){"K", "transmittance of the curtains",
                                            opening->curtains};
    if (opening->device.kind == PP_DEVICE_SCREEN)
        list[count++] = (struct correction){"S", "openness of the screen",
                                            opening->device.openness};
    if (opening->blind)
        list[count++] = (struct correction){
            "S", "mean transmittance of the blind for light from sky and ground",
            opening->blind->mean};
    return count;
}

double pp_allowance_factor(unsigned allowances, const struct pp_opening *opening)
{
    struct correction list[CORRECTIONS_MOST];
    int count = correct(list, allowances, opening);
    double factor = 1.0;
    for (int i = 0; i < count; i++)
        factor *= list[i].value;
    return factor;
}

double pp_allowance_decorations(const struct pp_method *method,
                                const struct pp_world *world)
{
    return method->gives == PP_GIVES_INTERNAL ? world->decorations : 1.0;
}

double pp_allowance_of(const struct pp_method *method, const struct pp_world *world,
                       const struct pp_opening *opening)
{
    return pp_allowance_factor(method->allowances, opening)
           * pp_allowance_decorations(method, world);
}

/* Value of a correction that a formula contains. */
static double value_in_formula(enum pp_allowance correction,
                               const struct pp_opening *opening)
{
    if (correction == PP_ALLOWS_OWN_GLASS)
        return opening->glass.diffuse;
    if (correction == PP_ALLOWS_FRAME)
        return opening->frame_factor;
    assert(correction == PP_ALLOWS_DIRT);
    return opening->maintenance;
}

void pp_allowance_put(struct pp_worksheet *sheet, enum pp_allowance correction,
                      const struct pp_opening *opening, const char *symbol,
                      const char *what, ...)
{
    va_list args;
    va_start(args, what);
    pp_worksheet_put_v(sheet, PP_UNIT_NUMBER, value_in_formula(correction, opening),
                       symbol, what, args);
    va_end(args);
}

void pp_allowance_steps(struct pp_steps *steps, const struct pp_method *method,
                        const struct pp_world *world, const struct pp_opening *opening,
                        char *product, size_t room)
{
    struct correction list[CORRECTIONS_MOST];
    int count = correct(list, method->allowances, opening);
    double D = pp_allowance_decorations(method, world);
    if (D != 1.0)
        list[count++] =
            (struct correction){"D", "deterioration factor of the decorations", D};
    product[0] = '\0';
    for (int i = 0; i < count; i++) {
        pp_steps_add_named(steps, PP_UNIT_NUMBER, list[i].value, list[i].symbol, "%s",
                           list[i].what);
        pp_text_append(product, room, " %s", list[i].symbol);
    }
}

void pp_allowance_words(char *text, size_t room, unsigned allowances)
{
    const struct {
        unsigned bit;
        const char *words;
    } parts[] = {
        {PP_ALLOWS_OWN_GLASS, "the opening's own glass"},
        {PP_ALLOWS_CLEAR_GLASS,
         allowances & PP_ALLOWS_NO_GLASS
             ? "clear single glass (no glass for unglazed openings)"
             : "clear single glass"},
        {PP_ALLOWS_FRAME, "the frame"},
        {PP_ALLOWS_DIRT, "dirt"},
    };
    const char *found[sizeof parts / sizeof parts[0]];
    int count = 0;
    for (size_t i = 0; i < sizeof parts / sizeof parts[0]; i++)
        if (allowances & parts[i].bit)
            found[count++] = parts[i].words;
    snprintf(text, room, "%s",
             count == 0 ? "none (neither glass, frame nor dirt)" : "");
    pp_text_append_list(text, room, found, count, " and ");
}

void pp_allowance_sentence(char *text, size_t room, const char *source,
                           unsigned allowances)
{
    char contents[160];
    pp_allowance_words(contents, sizeof contents, allowances);
    snprintf(text, room, "Allowances in the published figures [%s]: %s.", source,
             contents);
}
