/* component_steps.c - symbols and names of the components, and the steps that all
 * methods share. */
#include "methods/component_steps.h"

#include <stdio.h>
#include <string.h>

const char *const pp_component_steps_names[PP_COMPONENT_COUNT] = {
    [PP_SC] = "sky component",
    [PP_ERC] = "externally reflected component",
    [PP_IRC] = "internally reflected component",
    [PP_DF] = "daylight factor",
};

/* Symbols in formulae: lower case for one opening before corrections, upper case with
 * all corrections. */
static const char *const own_symbols[PP_COMPONENT_COUNT] = {"sc", "erc", "irc", "df"};
const char *const pp_component_steps_symbols[PP_COMPONENT_COUNT] = {"SC", "ERC", "IRC",
                                                                    "DF"};

enum pp_component pp_component_steps_given(const struct pp_method *method)
{
    static const enum pp_component given_by[] = {
        [PP_GIVES_DIRECT] = PP_SC,
        [PP_GIVES_INTERNAL] = PP_IRC,
        [PP_GIVES_WHOLE] = PP_DF,
    };
    return given_by[method->gives];
}

double pp_component_steps_figure(const struct pp_amounts *amounts,
                                 enum pp_component component)
{
    return component == PP_SC    ? amounts->sky
           : component == PP_ERC ? amounts->external
                                 : amounts->value;
}

/* Lists the components that have steps and returns their number, at most two. The
 * externally reflected component is omitted if it is 0 and the method has recorded no
 * step for it. */
static int components_of(enum pp_component list[2], const struct pp_method *method,
                         const struct pp_amounts *amounts, const struct pp_steps *steps,
                         int first)
{
    list[0] = pp_component_steps_given(method);
    list[1] = PP_ERC;
    bool reflects =
        amounts->external != 0.0 || pp_steps_find(steps, first, own_symbols[PP_ERC]);
    return list[0] == PP_SC && reflects ? 2 : 1;
}

void pp_component_steps_add(struct pp_steps *steps, const struct pp_method *method,
                            const struct pp_world *world, int index,
                            const struct pp_part *part,
                            const struct pp_amounts *corrected, int first)
{
    const struct pp_opening *opening = &world->openings[index];
    enum pp_component components[2];
    const struct pp_amounts read = {part->sky, part->external, part->value};
    int count = components_of(components, method, &read, steps, first);
    for (int i = 0; i < count; i++)
        if (!pp_steps_find(steps, first, own_symbols[components[i]]))
            pp_steps_add_named(steps, PP_UNIT_DAYLIGHT_FACTOR,
                               pp_component_steps_figure(&read, components[i]),
                               own_symbols[components[i]], "%s, as read",
                               pp_component_steps_names[components[i]]);
    char product[64];
    pp_allowance_steps(steps, method, world, opening, product, sizeof product);
    for (int i = 0; i < count; i++) {
        char symbol[16], formula[96];
        bool single = world->opening_count == 1;
        snprintf(symbol, sizeof symbol, single ? "%s" : "%s_%d",
                 pp_component_steps_symbols[components[i]], index + 1);
        snprintf(formula, sizeof formula, "%s%s", own_symbols[components[i]], product);
        pp_steps_add_worked(steps, PP_UNIT_DAYLIGHT_FACTOR,
                            pp_component_steps_figure(corrected, components[i]), symbol,
                            formula, "%s", pp_component_steps_names[components[i]]);
    }
}

void pp_component_steps_add_sums(struct pp_steps *steps, const struct pp_method *method,
                                 const struct pp_world *world,
                                 const struct pp_amounts *sum)
{
    enum pp_component components[2];
    int count = components_of(components, method, sum, steps, 0);
    steps->line = 0;
    for (int i = 0; i < count; i++)
        pp_steps_add_sum(steps, 0, world->opening_count,
                         pp_component_steps_symbols[components[i]],
                         pp_component_steps_names[components[i]]);
}
