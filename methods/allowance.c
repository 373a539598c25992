/* allowance.c - see allowance.h. */
#include "methods/allowance.h"
#include "model/base/text.h"

#include <stdio.h>

/* Diffuse transmittance of clear single glass in the reflected-component formulae. */
static const double printed_diffuse = 0.85;

/* G: diffuse transmittance over that of clear single glass. */
static double glass_type(const struct pp_glass *glass)
{
    return glass->diffuse / pp_glass_clear_single().diffuse;
}

double pp_allowance_reflected_glass(const struct pp_opening *opening)
{
    if (opening->glass.panes == 0)
        return 1.0;
    return printed_diffuse * glass_type(&opening->glass);
}

/* ---- corrections ---- */

struct correction {
    const char *symbol, *what;
    double value;
};

enum { CORRECTIONS_MOST = 8 };

/* What the glass still asks for: nothing, or one factor. */
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
            "T", "glass: diffuse transmittance, 0.85 for clear single",
            pp_allowance_reflected_glass(opening)};
    else if (bare)
        *correction = (struct correction){"G", "no glass: 1 over clear single's 0.85",
                                          1.0 / printed_diffuse};
    else
        *correction =
            (struct correction){"G", "glass: diffuse transmittance over clear single",
                                glass_type(&opening->glass)};
    return true;
}

/* All that figures with these allowances lack; the number of corrections. */
static int correct(struct correction list[CORRECTIONS_MOST], unsigned allowances,
                   const struct pp_opening *opening)
{
    int count = 0;
    if (!(allowances & PP_ALLOWS_DIRT))
        list[count++] = (struct correction){"M", "maintenance: what dirt leaves",
                                            opening->maintenance};
    count += correct_glass(&list[count], allowances, opening);
    if (!(allowances & PP_ALLOWS_FRAME))
        list[count++] = (struct correction){"B", "frame: area of glass over opening",
                                            opening->frame_factor};
    /* No published figure has curtains. */
    if (opening->curtains != 1.0)
        list[count++] = (struct correction){"K", "curtains: what they let through",
                                            opening->curtains};
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

void pp_allowance_steps(struct pp_steps *steps, unsigned allowances,
                        const struct pp_opening *opening, char *product, size_t room)
{
    struct correction list[CORRECTIONS_MOST];
    int count = correct(list, allowances, opening);
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
        {PP_ALLOWS_CLEAR_GLASS, allowances & PP_ALLOWS_NO_GLASS
                                    ? "clear single glass (none where there is none)"
                                    : "clear single glass"},
        {PP_ALLOWS_FRAME, "the frame"},
        {PP_ALLOWS_DIRT, "dirt"},
    };
    const char *found[sizeof parts / sizeof parts[0]];
    int count = 0;
    for (size_t i = 0; i < sizeof parts / sizeof parts[0]; i++)
        if (allowances & parts[i].bit)
            found[count++] = parts[i].words;
    snprintf(text, room, "%s", count == 0 ? "nothing of glass, frame or dirt" : "");
    pp_text_append_list(text, room, found, count, " and ");
}
