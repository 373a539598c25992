/* limits_chapter.c - see limits_chapter.h. */
#include "reports/page/limits_chapter.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

#include "model/light/rough/rough_finishes.h"
#include "studies/criteria/trees_left_out.h"

/* True if any room was assessed by the criterion of that name. */
static bool is_assessed(const struct pp_assessments *all, const char *criterion)
{
    for (int i = 0; i < all->count; i++)
        for (int k = 0; k < all->list[i].answers.count; k++)
            if (strcmp(all->list[i].answers.list[k].criterion->name, criterion) == 0)
                return true;
    return false;
}

static bool has_factors(const struct pp_assessments *all)
{
    for (int i = 0; i < all->count; i++)
        if (all->list[i].has_factors)
            return true;
    return false;
}

/* True if the file of any room defines materials with physical roughness. */
static bool has_rough_materials(const struct pp_assessments *all)
{
    for (int i = 0; i < all->count; i++)
        if (pp_rough_finishes_rough_count(all->list[i].room->world->materials) > 0)
            return true;
    return false;
}

/* True if trees in front of the windows of any room are left out of criteria. */
static bool leaves_trees_out(const struct pp_assessments *all)
{
    struct pp_trees_left_out trees;
    for (int i = 0; i < all->count; i++)
        if (pp_trees_left_out_find(&trees, &all->list[i]))
            return true;
    return false;
}

/* Finds the lowest and highest reflectance of the ground outside. */
static void find_ground(double range[2], const struct pp_assessments *all)
{
    range[0] = INFINITY;
    range[1] = -INFINITY;
    for (int i = 0; i < all->count; i++) {
        double reflectance = all->list[i].room->light.ground_reflectance;
        range[0] = fmin(range[0], reflectance);
        range[1] = fmax(range[1], reflectance);
    }
}

static void say_geometry(struct pp_document *document, const struct pp_assessments *all)
{
    double ground[2];
    find_ground(ground, all);
    pp_document_heading(document, 3, "Geometry and surfaces");
    pp_document_paragraph(
        document, PP_TONE_PLAIN,
        "Rooms and surroundings are taken from the file %s. The program cannot check "
        "them against the site: they are as accurate as the surveys and drawings "
        "behind the file. Trees, furniture and other objects count only if they are in "
        "the file.",
        all->count ? all->list[0].room->file : "");
    if (leaves_trees_out(all))
        pp_document_paragraph(
            document, PP_TONE_PLAIN,
            "Crowns of trees are part of simulations, but are left out of the vertical "
            "sky component, the 25 degree rule, the no-sky line, sunlight, view out "
            "and "
            "rights of light.");
    if (ground[0] == ground[1])
        pp_document_paragraph(document, PP_TONE_PLAIN,
                              "The ground reflectance is %.3g.", ground[0]);
    else if (ground[0] < ground[1])
        pp_document_paragraph(document, PP_TONE_PLAIN,
                              "The ground reflectance is %.3g to %.3g.", ground[0],
                              ground[1]);
    pp_document_paragraph(
        document, PP_TONE_PLAIN,
        "Surfaces are matt and evenly coloured, with the reflectances in the file. "
        "Losses for glass, frames and dirt are as in the file, and each is applied "
        "once. Curtains and blinds are open unless the file says otherwise.");
    if (has_rough_materials(all))
        pp_document_paragraph(
            document, PP_TONE_PLAIN,
            "Surfaces of a <material> of the file are not matt: simulated daylight "
            "factors include their reflections, while hand methods use their "
            "reflectance for diffuse light.");
}

static void say_daylight(struct pp_document *document, const struct pp_assessments *all)
{
    if (!has_factors(all))
        return;
    pp_document_heading(document, 3, "Daylight factors");
    pp_document_paragraph(
        document, PP_TONE_PLAIN,
        "Daylight factors are for the sky in the file, by default the CIE overcast "
        "sky, which is the same in all directions of the compass. They do not depend "
        "on the time and include no sunlight.");
    if (all->options->simulate)
        pp_document_paragraph(
            document, PP_TONE_PLAIN,
            "Simulated figures are followed by one standard error of the random "
            "samples, which does not include errors of the model. A verdict is given "
            "if the probability that it is correct is 95 %% or more; otherwise the "
            "criterion is undecided.");
    else
        pp_document_paragraph(
            document, PP_TONE_PLAIN,
            "Hand methods assume simplified rooms. The range after a figure contained "
            "the simulated value in 95 of 100 similar rooms. The figure itself may be "
            "outside that range if the method tends to be too high or too low.");
}

static void say_planning(struct pp_document *document, const struct pp_assessments *all)
{
    bool sky = is_assessed(all, "vertical-sky") || is_assessed(all, "no-sky-line");
    bool sun = is_assessed(all, "sunlight");
    if (!sky && !sun)
        return;
    pp_document_heading(document, 3, "BR 209");
    pp_document_paragraph(
        document, PP_TONE_PLAIN,
        "BR 209 [BR209] is advisory, and its figures should be applied flexibly. Each "
        "window counts once: it meets the guide if its vertical sky component is at "
        "least 27 %%, or at least 0.8 of its former value. The 25 degree rule is only "
        "a first check, so exceeding it is not a failure. The bands of loss (20, 30, "
        "40 %%) are common practice in impact assessments and not part of the guide.");
    if (sun)
        pp_document_paragraph(
            document, PP_TONE_PLAIN,
            "Sunlight is calculated for windows that face within 90 degrees of due "
            "south. Without a weather file the hours are possible hours, as if the sky "
            "were always clear, and have no verdict. With a weather file they are "
            "probable hours for the years in that file.");
}

static void say_other(struct pp_document *document, const struct pp_assessments *all)
{
    if (is_assessed(all, "en17037") || is_assessed(all, "uk-annex")) {
        pp_document_heading(document, 3, "EN 17037");
        pp_document_paragraph(
            document, PP_TONE_PLAIN,
            "Each verdict states the median diffuse illuminance on which its "
            "illuminances are based. It also states the grid on the working plane; the "
            "verdict takes the error of the grid into account.");
    }
    if (is_assessed(all, "rights-of-light"))
        pp_document_paragraph(document, PP_TONE_PLAIN,
                              "Areas inside the 0.2 %% contour are technical figures. "
                              "Whether a right exists or is infringed is a question of "
                              "law, which this report does not answer.");
    pp_document_heading(document, 3, "Not assessed");
    pp_document_paragraph(
        document, PP_TONE_PLAIN,
        "Glare, %soverheating, electric light and energy are not assessed. The figures "
        "apply to the design and site in the file: a change to the design or to a "
        "building nearby requires a new assessment.",
        is_assessed(all, "view-out") ? "" : "views, ");
}

void pp_limits_chapter(struct pp_document *document,
                       const struct pp_site_report *report)
{
    pp_document_heading(document, 2, "Limits and assumptions");
    say_geometry(document, report->all);
    say_daylight(document, report->all);
    say_planning(document, report->all);
    say_other(document, report->all);
}
