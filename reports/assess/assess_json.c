/* assess_json.c - makes the JSON object of an assessed room, criterion by criterion. */
#include "reports/assess/assess_json.h"

#include <math.h>

#include "reports/assess/trees_note.h"
#include "reports/parts/figure_unit.h"
#include "reports/parts/json.h"
#include "reports/parts/json_room.h"
#include "reports/parts/print_band.h"
#include "reports/parts/print_reliability.h"
#include "reports/gains_report.h"

/* Makes the object { "of": "W1, south", "line": 9, "label": "W1", "wall": "south",
 * "figure": 30.1, "unit": "%", "wanted": 27, "bound": "least", "verdict": "met" }, with
 * further members if the finding has them. */
static struct json_object *finding_object(const struct pp_finding *finding,
                                          const struct pp_world *world,
                                          double external_lux)
{
    struct json_object *object = json_object_new_object();
    double scale = pp_figure_scale(finding->kind);
    bool judged = isfinite(finding->figure);
    bool good = object && pp_json_text(object, "of", finding->what);
    if (good && finding->line > 0)
        good = pp_json_add(object, "line", json_object_new_int(finding->line))
               && pp_json_room_add_opening_names(object, world, finding->line);
    if (good && finding->season)
        good = pp_json_text(object, "season", finding->season);
    if (good)
        good = pp_json_number(object, "figure", scale * finding->figure);
    if (good && judged)
        good = pp_json_text(object, "unit", pp_figure_unit(finding->kind));
    if (good && isfinite(finding->std_error))
        good = pp_json_number(object, "se", scale * finding->std_error);
    if (good && isfinite(finding->grid_error))
        good = pp_json_number(object, "grid-error", scale * finding->grid_error);
    if (good && pp_band_is_known(finding->band))
        good = pp_print_band_json(object, finding->band)
               && pp_json_add(object, "open",
                              json_object_new_boolean(pp_finding_is_open(finding)));
    if (good && judged && external_lux > 0.0 && finding->kind == PP_FIGURE_FACTOR)
        good = pp_json_number(object, "lux", external_lux * finding->figure);
    if (good && isfinite(finding->before))
        good = pp_json_number(object, "before",
                              pp_figure_scale(finding->compared) * finding->before)
               && pp_json_number(object, "now",
                                 pp_figure_scale(finding->compared) * finding->now);
    if (good && isfinite(finding->before_unshaded))
        good = pp_json_number(object, "before-unshaded",
                              pp_figure_scale(finding->compared)
                                  * finding->before_unshaded);
    if (good && isfinite(finding->now_unshaded))
        good =
            pp_json_number(object, "now-unshaded",
                           pp_figure_scale(finding->compared) * finding->now_unshaded);
    if (good && isfinite(finding->wanted))
        good = pp_json_number(object, "wanted", scale * finding->wanted)
               && pp_json_text(object, "bound", finding->at_most ? "most" : "least");
    if (good && isfinite(finding->reached_over))
        good = pp_json_number(object, "reached_over", 100.0 * finding->reached_over);
    if (good && isfinite(finding->over_error))
        good = pp_json_number(object, "over-error", 100.0 * finding->over_error);
    if (good)
        good = pp_json_text(object, "verdict", pp_finding_verdict(finding->verdict));
    if (good && isfinite(finding->confidence))
        good = pp_json_number(
            object, finding->verdict == PP_UNDECIDED ? "probability" : "confidence",
            finding->confidence);
    if (good && finding->is_optional)
        good = pp_json_add(object, "optional", json_object_new_boolean(true));
    if (good && finding->decided_by)
        good = pp_json_text(object, "decided_by", finding->decided_by);
    if (good && finding->note[0])
        good = pp_json_text(object, finding->verdict == PP_NOT_JUDGED ? "why" : "note",
                            finding->note);
    if (good)
        pp_json_on_one_line(object);
    return pp_json_whole(object, good);
}

static bool add_findings(struct json_object *object,
                         const struct pp_finding_list *findings,
                         const struct pp_world *world, double external_lux)
{
    struct json_object *list = json_object_new_array();
    bool good = pp_json_add(object, "findings", list);
    for (int i = 0; i < findings->count && good; i++)
        good = pp_json_append(list,
                              finding_object(&findings->list[i], world, external_lux));
    return good;
}

static struct json_object *answer_object(const struct pp_answer *answer,
                                         const struct pp_world *world,
                                         double external_lux)
{
    struct json_object *object = json_object_new_object();
    bool good = object && pp_json_text(object, "criterion", answer->criterion->name)
                && pp_json_text(object, "title", answer->criterion->title)
                && pp_json_text(object, "source", answer->criterion->source);
    if (good && answer->criterion->withdrawn)
        good = pp_json_text(object, "withdrawn", answer->criterion->withdrawn);
    if (good && answer->findings.basis[0])
        good = pp_json_text(object, "basis", answer->findings.basis);
    good = good && add_findings(object, &answer->findings, world, external_lux);
    return pp_json_whole(object, good);
}

static bool add_criteria(struct json_object *object,
                         const struct pp_assessment *assessment, double external_lux)
{
    const struct pp_world *world = assessment->room->world;
    struct json_object *list = json_object_new_array();
    bool good = pp_json_add(object, "criteria", list);
    for (int i = 0; i < assessment->answers.count && good; i++)
        good = pp_json_append(
            list, answer_object(&assessment->answers.list[i], world, external_lux));
    return good;
}

static struct json_object *room_object(const void *everything, int index)
{
    const struct pp_assessments *all = everything;
    const struct pp_assessment *assessment = &all->list[index];
    const struct pp_study_options *options = all->options;
    const struct pp_world *world = assessment->room->world;
    struct json_object *object = json_object_new_object();
    bool good = object && pp_json_text(object, "format", "pepperpot-assess-1");
    if (good && all->more_than_one_file)
        good = pp_json_text(object, "file", assessment->room->file);
    if (good)
        good =
            pp_json_text(object, "room", world->name)
            && pp_json_text(object, "sky", pp_sky_name(&assessment->room->light.sky));
    good = good && pp_json_warnings(object, assessment->room->doubts);
    if (good && assessment->before)
        good = pp_json_text(object, "before", assessment->before->file);
    if (good)
        good = pp_json_number(object, "median_diffuse", assessment->median.lux)
               && pp_json_text(object, "median_diffuse_by", assessment->median.how);
    if (good && options->external_lux > 0.0)
        good = pp_json_number(object, "external", options->external_lux);
    if (good && options->simulate && assessment->has_factors)
        good = pp_json_simulation(object, options, assessment->by_clock);
    if (good && !assessment->report.finished)
        good = pp_json_add(object, "finished", json_object_new_boolean(false));
    if (good && assessment->has_factors) {
        struct pp_reliability reliability = pp_reliability_of(&assessment->report);
        good = pp_print_reliability_json(object, &reliability);
    }
    if (good)
        good = add_criteria(object, assessment, options->external_lux)
               && pp_trees_note_json(object, assessment, 1);
    if (good && assessment->has_gains)
        good = pp_gains_report_json(object, &assessment->gains);
    return pp_json_whole(object, good);
}

enum pp_status pp_assess_json(const struct pp_assessments *all, FILE *out,
                              struct pp_error *err)
{
    return pp_json_print_rooms(out, room_object, all, all->count, all->several, err);
}
