/* mirror_image_sky.c - light that remains beside a new building, compared with the
 * light that would remain beside the old building's mirror image at the boundary
 * ([BR209] appendix F, from memory, as the text was not available):
 *
 *   VSC proposed >= VSC with the mirror image             at each vertical window
 *   area that sees sky, proposed >= with the mirror image
 *
 * The appendix gives these as targets instead of 27 % and of 0.8 of the former value,
 * if the old building is close to the boundary, or if there is nothing opposite.
 */
#include <math.h>

#include "studies/criteria/bearing.h"
#include "studies/criteria/criteria.h"
#include "studies/criteria/windows/opening_words.h"
#include "studies/criteria/windows/vertical_sky.h"
#include "studies/lit_line.h"

static const char no_place[] = "the room has no position in a building",
                  no_plane[] = "the room has no working plane",
                  area_words[] = "area with a view of the sky";

static enum pp_status add_window(struct pp_finding_list *findings,
                                 const struct pp_inquiry *inquiry, int index,
                                 struct pp_error *err)
{
    const struct pp_opening *opening = &inquiry->world->openings[index];
    const struct pp_opening *image =
        &inquiry->mirrored->openings[inquiry->mirrored_pairs[index]];
    char words[PP_OPENING_WORDS];
    double now, mirrored;
    enum pp_status status =
        pp_vertical_sky_at_point(&now, inquiry->world, opening, inquiry->french_m, err);
    if (status == PP_OK)
        status = pp_vertical_sky_at_point(&mirrored, inquiry->mirrored, image,
                                          inquiry->french_m, err);
    if (status != PP_OK)
        return status;
    pp_opening_words(words, inquiry->world, opening);
    struct pp_finding finding =
        pp_finding_of(PP_FIGURE_FACTOR, now, mirrored, false, "%s", words);
    finding.line = opening->line;
    pp_finding_compares(&finding, PP_FIGURE_FACTOR, now, NAN);
    return pp_finding_list_add(findings, &finding, err);
}

static enum pp_status add_area(struct pp_finding_list *findings,
                               const struct pp_inquiry *inquiry, struct pp_error *err)
{
    const char *refused = pp_lit_line_refuses(inquiry->world, inquiry->mirrored);
    struct pp_lit_area now = {0}, mirrored = {0};
    struct pp_finding finding = pp_finding_not_judged(refused, area_words);
    enum pp_status status = PP_OK;
    if (!refused)
        status = pp_lit_line_find(&now, inquiry->world, PP_LIT_NO_SKY, err);
    if (!refused && status == PP_OK)
        status = pp_lit_line_find(&mirrored, inquiry->mirrored, PP_LIT_NO_SKY, err);
    if (!refused && status == PP_OK && now.plane_m2 > 0.0) {
        finding = pp_finding_of(PP_FIGURE_AREA, now.lit_m2, mirrored.lit_m2, false,
                                area_words);
        pp_finding_compares(&finding, PP_FIGURE_AREA, now.lit_m2, NAN);
        if (now.lit_m2 < mirrored.lit_m2)
            pp_finding_within(&finding, now.error_m2 + mirrored.error_m2);
    } else if (!refused) {
        finding = pp_finding_not_judged(no_plane, area_words);
    }
    pp_lit_area_clear(&now);
    pp_lit_area_clear(&mirrored);
    return status == PP_OK ? pp_finding_list_add(findings, &finding, err) : status;
}

static enum pp_status assess_mirror_image_sky(const struct pp_inquiry *inquiry,
                                              struct pp_finding_list *findings,
                                              struct pp_error *err)
{
    const struct pp_world *world = inquiry->world;
    enum pp_status status = PP_OK;
    pp_finding_list_add_basis(findings,
                              "target: the value with a mirror image of the building "
                              "at the boundary in place "
                              "of the proposal, with the same height and ground level");
    if (!world->placement.given) {
        struct pp_finding finding = pp_finding_not_judged(no_place, "windows");
        return pp_finding_list_add(findings, &finding, err);
    }
    for (int i = 0; i < world->opening_count && status == PP_OK; i++)
        if (pp_vertical_sky_is_upright(&world->openings[i]))
            status = add_window(findings, inquiry, i, err);
    return status == PP_OK ? add_area(findings, inquiry, err) : status;
}

const struct pp_criterion pp_criterion_mirror_image = {
    .name = "mirror-image",
    .title = "View of the sky compared with the building's mirror image",
    .source = "BR209",
    .summary = "at least as much sky as with the building's mirror image opposite "
               "(--mirror-image)",
    .needs_mirror_image = true,
    .bears_on_use = pp_bearing_needs_daylight,
    .without_trees = true,
    .evaluate = assess_mirror_image_sky,
};
