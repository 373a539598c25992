/* allowance.h - the one place that settles glass, frame, dirt and curtains.
 *
 * Published figures differ in what they already contain. A method declares that; what
 * is still missing for an opening is multiplied on here, and nothing is counted twice:
 *
 *     DF = ((SC + ERC) M G B + IRC M G D) K                                  [BRE310]
 *
 * M maintenance, G glass type over clear single glass, B net glass area over opening
 * area, K curtains (not of the source), D deterioration of decorations. In formulae that
 * work with the net glass area W, B is in W already (PP_ALLOWS_FRAME). K is in no
 * published figure. D is the room's, not an opening's: methods/evaluate.c multiplies it
 * on the internally reflected component.
 */
#ifndef PP_METHODS_ALLOWANCE_H
#define PP_METHODS_ALLOWANCE_H

#include <stddef.h>

#include "model/results/steps.h"
#include "model/room/world.h"

enum pp_allowance {
    PP_ALLOWS_NOTHING = 0,
    PP_ALLOWS_CLEAR_GLASS =
        1 << 0,                   /* clear single glass, its angular losses included */
    PP_ALLOWS_OWN_GLASS = 1 << 1, /* the opening's own glazing */
    PP_ALLOWS_FRAME = 1 << 2,     /* frame and bars */
    PP_ALLOWS_DIRT = 1 << 3,      /* dirt on the glass */
    PP_ALLOWS_NO_GLASS = 1 << 4,  /* with CLEAR_GLASS: has figures of its own, which
                                     * contain no glass, for unglazed openings */
};

/* The factor that a figure which contains `allowances` still needs for this opening.
 * Figures for clear glass are turned into the opening's own by the ratio G of the
 * diffuse transmittances; for an unglazed opening by 1/0.85, unless the method has
 * figures without glass (PP_ALLOWS_NO_GLASS). */
double pp_allowance_factor(unsigned allowances, const struct pp_opening *opening);

/* Sets down the corrections that make up that factor, one by one, and puts their
 * symbols into `product` as further factors of a formula: " M G B", or nothing. */
void pp_allowance_steps(struct pp_steps *steps, unsigned allowances,
                        const struct pp_opening *opening, char *product, size_t room);

/* What figures with these allowances contain: "clear single glass and the frame",
 * "nothing of glass, frame or dirt". */
void pp_allowance_words(char *text, size_t room, unsigned allowances);

/* The diffuse transmittance that the reflected-component formulae take: 0.85 G, 1 for
 * an unglazed opening. */
double pp_allowance_reflected_glass(const struct pp_opening *opening);

#endif
