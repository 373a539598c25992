/* limits_chapter.c - see limits_chapter.h. */
#include "reports/page/limits_chapter.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

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

/* Least and greatest reflectance of the ground outside. */
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
        "Rooms and surroundings are those of the file %s. The program cannot check "
        "them "
        "against the site: their accuracy is that of the surveys and drawings behind "
        "the "
        "file. Trees, furniture and other objects count only if they are in the file.",
        all->count ? all->list[0].room->file : "");
    if (ground[0] == ground[1])
        pp_document_paragraph(document, PP_TONE_PLAIN,
                              "The ground outside reflects %.3g of the light.",
                              ground[0]);
    else if (ground[0] < ground[1])
        pp_document_paragraph(document, PP_TONE_PLAIN,
                              "The ground outside reflects %.3g to %.3g of the light.",
                              ground[0], ground[1]);
    pp_document_paragraph(document, PP_TONE_PLAIN,
                          "Surfaces are matt and of even colour, with the reflectances "
                          "of the file. Glass, "
                          "frames and dirt are those of the file, each once. Curtains "
                          "and blinds are open "
                          "unless the file says otherwise.");
}

static void say_daylight(struct pp_document *document, const struct pp_assessments *all)
{
    if (!has_factors(all))
        return;
    pp_document_heading(document, 3, "Daylight factors");
    pp_document_paragraph(
        document, PP_TONE_PLAIN,
        "Daylight factors are for the sky that the file names, by default the CIE "
        "overcast sky. They do not depend on the time, or on the direction of a "
        "window, "
        "and include no sunlight.");
    if (all->options->simulate)
        pp_document_paragraph(
            document, PP_TONE_PLAIN,
            "Simulated figures are followed by one standard error of the random "
            "samples. "
            "It does not include errors of the model. A verdict is given where it is "
            "right with a probability of 95 %% or more; otherwise it is undecided.");
    else
        pp_document_paragraph(
            document, PP_TONE_PLAIN,
            "Figures by hand methods rest on simplified rooms. The range after a "
            "figure "
            "held the simulated value in 95 of 100 similar rooms. The figure itself "
            "may "
            "lie outside that range: the method then errs in one direction.");
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
        "BR 209 [BR209] is advisory, and its figures are to be applied with "
        "flexibility. "
        "A window counts once: it meets the guide with a vertical sky component of 27 "
        "%% "
        "or with 0.8 of its former value. The 25 degree rule is a first check and no "
        "failure. Bands of loss (20, 30, 40 %%) are practice of assessments of effects "
        "and not part of the guide.");
    if (sun)
        pp_document_paragraph(
            document, PP_TONE_PLAIN,
            "Sunlight is counted for windows that face within 90 degrees of due south. "
            "Without a weather file the hours are possible hours, as if the sky were "
            "always clear; they are not judged. With a weather file they are probable "
            "hours of that file's years.");
}

static void say_other(struct pp_document *document, const struct pp_assessments *all)
{
    if (is_assessed(all, "en17037") || is_assessed(all, "uk-annex")) {
        pp_document_heading(document, 3, "EN 17037");
        pp_document_paragraph(
            document, PP_TONE_PLAIN,
            "Illuminances are those of the median diffuse illuminance outside that is "
            "named with each verdict. The grid by which the plane is judged is named "
            "there, too, and its error is part of the verdict.");
    }
    if (is_assessed(all, "rights-of-light"))
        pp_document_paragraph(
            document, PP_TONE_PLAIN,
            "Areas inside the 0.2 %% contour are a technical figure. Whether a right "
            "exists, or is infringed, is a question of law that this report leaves "
            "open.");
    pp_document_heading(document, 3, "Not assessed");
    pp_document_paragraph(
        document, PP_TONE_PLAIN,
        "Glare, views, overheating, electric light and energy are not assessed. The "
        "figures hold for the state of the file: a change of the design, or of a "
        "building nearby, needs another assessment.");
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
