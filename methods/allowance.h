/* allowance.h - the corrections for glass, frame, dirt, curtains, blinds and
 * decorations.
 *
 * Published figures differ in the corrections that they already contain. Each method
 * declares the corrections that its figures contain (pp_method.allowances).
 * pp_allowance_of is the product of all others, so that no correction is counted twice:
 *
 *     DF = ((SC + ERC) M G B + IRC M G D) K S                                [BRE310]
 *
 *   M   maintenance: transmittance of the dirty glass over that of clean glass
 *   G   glass type: diffuse transmittance over that of clear single glass
 *   B   frame: net glass area over opening area
 *   K   curtains: their transmittance (not in the source, nor in any published figure)
 *   S   screen or blind: openness of the screen, or mean transmittance of the blind
 *       (light/slats/blind.h); likewise not in the source
 *   D   deterioration of decorations
 *
 * Formulae with the net glass area W already include B in W (PP_ALLOWS_FRAME). D
 * applies to the room, not to a single opening, and only to the internally reflected
 * component.
 *
 * Methods obtain an opening's frame factor, maintenance and curtains only through this
 * file. Points and the average of a report (methods/method_run.c), the plane of a
 * direct method (direct_plane.c) and the sheets of diagrams multiply a method's figures
 * by pp_allowance_of. If a formula contains a correction, pp_allowance_put records it
 * on the worksheet. The simulations take the same corrections of an opening from
 * model/room/surface_materials.h.
 */
#ifndef PP_METHODS_ALLOWANCE_H
#define PP_METHODS_ALLOWANCE_H

#include <stddef.h>

#include "model/results/worksheet.h"
#include "model/room/world.h"

struct pp_method; /* methods/method.h */

/* Diffuse transmittance of clear single glass in the formulae of the internally
 * reflected component [BRE310]. */
#define PP_ALLOWANCE_CLEAR_DIFFUSE 0.85

/* The corrections that a figure already contains. */
enum pp_allowance {
    PP_ALLOWS_NOTHING = 0,
    PP_ALLOWS_CLEAR_GLASS = 1 << 0, /* clear single glass, with its angular losses */
    PP_ALLOWS_OWN_GLASS = 1 << 1,   /* the opening's own glazing */
    PP_ALLOWS_FRAME = 1 << 2,       /* frame and bars */
    PP_ALLOWS_DIRT = 1 << 3,        /* dirt on the glass */
    PP_ALLOWS_NO_GLASS = 1 << 4,    /* with CLEAR_GLASS: the method has separate figures
                                     * for unglazed openings */
};

/* Product of the corrections for this opening that are not contained in figures with
 * `allowances`. The ratio G converts figures for clear glass to the opening's own
 * glass. For an unglazed opening G is 1/0.85, unless the method has figures without
 * glass (PP_ALLOWS_NO_GLASS). Figures that contain no glass are multiplied by the
 * diffuse transmittance of the opening's own glass instead. */
double pp_allowance_factor(unsigned allowances, const struct pp_opening *opening);

/* Factor D of the deterioration of decorations for the method's figures; 1 for methods
 * that do not give the internally reflected component. */
double pp_allowance_decorations(const struct pp_method *method,
                                const struct pp_world *world);

/* Factor by which the method's figures for an opening of that world must be multiplied:
 * all corrections that they lack, D included. */
double pp_allowance_of(const struct pp_method *method, const struct pp_world *world,
                       const struct pp_opening *opening);

/* Records on the worksheet a correction that a formula contains, under its printed
 * symbol and described as for pp_worksheet_put: the diffuse transmittance of the
 * opening's own glass (PP_ALLOWS_OWN_GLASS), the frame factor (PP_ALLOWS_FRAME), or the
 * maintenance factor (PP_ALLOWS_DIRT). */
void pp_allowance_put(struct pp_worksheet *sheet, enum pp_allowance correction,
                      const struct pp_opening *opening, const char *symbol,
                      const char *what, ...) __attribute__((format(printf, 5, 6)));

/* Records the factors of pp_allowance_of as steps, one by one, and writes their symbols
 * to `product` as further factors of a formula: " M G B", or nothing. */
void pp_allowance_steps(struct pp_steps *steps, const struct pp_method *method,
                        const struct pp_world *world, const struct pp_opening *opening,
                        char *product, size_t room);

/* The allowances in words: "clear single glass and the frame", "no allowance for glass,
 * frame or dirt". */
void pp_allowance_words(char *text, size_t room, unsigned allowances);

/* Writes a sentence on a method's source and allowances: "Published figures [HLG58]
 * include: clear single glass." */
void pp_allowance_sentence(char *text, size_t room, const char *source,
                           unsigned allowances);

/* Diffuse transmittance of the glass for formulae of the internally reflected
 * component: 0.85 G, where 0.85 is the value of clear single glass; 1 for an unglazed
 * opening. */
double pp_allowance_reflected_glass(const struct pp_opening *opening);

/* Net glass area of an opening (m2), without recording steps. */
double pp_allowance_net_glass_m2(const struct pp_opening *opening);

/* Formulae of the net glass area under its two published symbols, W and Ag. */
extern const struct pp_formula pp_allowance_glass_W, pp_allowance_glass_Ag;

/* Puts the opening's area and frame factor on the worksheet, calculates the net glass
 * area by one of these formulae, and returns it (m2). */
double pp_allowance_net_glass(struct pp_worksheet *sheet,
                              const struct pp_formula *formula,
                              const struct pp_opening *opening);

#endif
