/* assess_table_json.c - see assess_table_json.h. */
#include "reports/assess/assess_table_json.h"

#include <math.h>

#include "reports/assess/trees_note.h"
#include "reports/parts/figure_unit.h"
#include "reports/parts/json.h"
#include "reports/parts/json_room.h"
#include "studies/criteria/br209_count.h"
#include "studies/criteria/site_table.h"

static struct json_object *row_object(const struct pp_site_row *row, bool compares)
{
    const struct pp_world *world = row->room->room->world;
    const struct pp_finding *finding = row->finding;
    double scale = pp_figure_scale(compares ? finding->compared : finding->kind);
    struct json_object *object = json_object_new_object();
    bool good = object && pp_json_text(object, "room", world->name)
                && pp_json_text(object, "ref", world->ref)
                && pp_json_text(object, "use",
                                world->use ? pp_room_use_words[world->use] : NULL)
                && (!world->address || pp_json_text(object, "address", world->address))
                && (!row->room->is_new
                    || pp_json_add(object, "new", json_object_new_boolean(true)))
                && pp_json_text(object, "criterion", row->criterion->name)
                && pp_json_text(object, "of", finding->what);
    if (good && finding->line > 0)
        good = pp_json_add(object, "line", json_object_new_int(finding->line))
               && pp_json_room_add_opening_names(object, world, finding->line);
    if (good && compares)
        good = pp_json_number(object, "existing", scale * row->existing)
               && pp_json_number(object, "proposed", scale * row->proposed)
               && pp_json_number(object, "ratio", row->ratio)
               && pp_json_number(object, "loss", 100.0 * (1.0 - row->ratio))
               && pp_json_text(object, "unit", pp_figure_unit(finding->compared));
    if (good && row->in_cumulative)
        good = pp_json_number(object, "cumulative", scale * row->cumulative)
               && pp_json_number(object, "cumulative-ratio", row->cumulative_ratio)
               && pp_json_text(object, "cumulative-verdict",
                               pp_finding_verdict(row->in_cumulative->verdict));
    if (good && row->by_mirror_image)
        good = pp_json_number(object, "mirror_image", scale * row->mirrored)
               && pp_json_text(object, "mirror_image_verdict",
                               pp_finding_verdict(row->by_mirror_image->verdict));
    if (good && !compares)
        good = pp_json_number(object, "figure", scale * finding->figure)
               && pp_json_number(object, "wanted", scale * finding->wanted)
               && pp_json_text(object, "unit", pp_figure_unit(finding->kind));
    if (good && isfinite(finding->std_error))
        good = pp_json_number(object, "se", scale * finding->std_error);
    if (good)
        good = pp_json_text(object, "verdict", pp_finding_verdict(finding->verdict));
    if (good && finding->note[0])
        good = pp_json_text(object, finding->verdict == PP_NOT_JUDGED ? "why" : "note",
                            finding->note);
    if (good)
        pp_json_on_one_line(object);
    return pp_json_whole(object, good);
}

static bool add_areas(struct json_object *object, const struct pp_lit_change *lit)
{
    bool good = pp_json_number(object, "area", lit->plane_m2)
                && pp_json_number(object, "existing", lit->before_m2)
                && pp_json_number(object, "proposed", lit->lit_m2)
                && pp_json_number(object, "share", 100.0 * lit->lit_m2 / lit->plane_m2)
                && pp_json_number(object, "lost", lit->lost_m2);
    static const char *const zones[] = {[PP_ZONE_FRONT] = "lost_front",
                                        [PP_ZONE_FIRST] = "lost_first",
                                        [PP_ZONE_SECOND] = "lost_second",
                                        [PP_ZONE_MAKEWEIGHT] = "lost_makeweight"};
    for (int i = 0; i < PP_ZONE_COUNT && good; i++)
        good = pp_json_number(object, zones[i], lit->loss.zones_m2[i]);
    return good
           && pp_json_number(object, "lost_as_first_zone", lit->loss.equivalent_m2);
}

static struct json_object *rights_row(const struct pp_site_row *row)
{
    const struct pp_world *world = row->room->room->world;
    struct json_object *object = json_object_new_object();
    bool good =
        object && pp_json_text(object, "room", world->name)
        && pp_json_text(object, "ref", world->ref)
        && pp_json_text(object, "use",
                        world->use ? pp_room_use_words[world->use] : NULL)
        && (!row->lit || add_areas(object, row->lit))
        && pp_json_text(object, "verdict", pp_finding_verdict(row->finding->verdict));
    if (good && row->finding->note[0])
        good = pp_json_text(object, row->lit ? "note" : "why", row->finding->note);
    if (good)
        pp_json_on_one_line(object);
    return pp_json_whole(object, good);
}

static struct json_object *sum_object(const struct pp_lit_change *sum)
{
    struct json_object *object = json_object_new_object();
    bool good = object && add_areas(object, sum);
    if (good)
        pp_json_on_one_line(object);
    return pp_json_whole(object, good);
}

/* Makes the object for rights of light: one row per room, and the sum of the assessed
 * rooms. */
static struct json_object *rights_object(const struct pp_site_table *table)
{
    struct json_object *object = json_object_new_object(),
                       *rooms = object ? json_object_new_array() : NULL;
    bool good = object && pp_json_add(object, "rooms", rooms);
    for (int i = 0; i < table->rights_count && good; i++)
        good = pp_json_append(rooms, rights_row(&table->rights[i]));
    good = good && pp_json_add(object, "sum", sum_object(&table->rights_sum));
    return pp_json_whole(object, good);
}

static bool append_rows(struct json_object *list, const struct pp_site_row *rows,
                        int count, bool compares)
{
    bool good = true;
    for (int i = 0; i < count && good; i++)
        good = pp_json_append(list, row_object(&rows[i], compares));
    return good;
}

static bool add_rows(struct json_object *object, const char *key,
                     const struct pp_site_row *rows, int count, bool compares)
{
    struct json_object *list = json_object_new_array();
    return pp_json_add(object, key, list) && append_rows(list, rows, count, compares);
}

/* Adds the findings of the other criteria with their bounds. Findings on sunlight are
 * included, although they also have a separate list. */
static bool add_others(struct json_object *object, const struct pp_site_table *table)
{
    struct json_object *list = json_object_new_array();
    return pp_json_add(object, "others", list)
           && append_rows(list, table->suns, table->sun_count, false)
           && append_rows(list, table->others, table->other_count, false);
}

/* Makes an object with the numbers of windows and rooms that meet BR 209, and of
 * windows in each band of loss. */
static struct json_object *br209_object(const struct pp_assessments *all)
{
    static const char *const bands[PP_LOSS_BANDS] = {
        "loss-below-20", "loss-20-to-30", "loss-30-to-40", "loss-40-or-more"};
    const struct pp_br209_count count = pp_br209_count_of(all->list, all->count);
    struct json_object *object = json_object_new_object();
    bool good =
        object && pp_json_add(object, "windows", json_object_new_int(count.windows))
        && pp_json_add(object, "windows-met", json_object_new_int(count.windows_met))
        && pp_json_add(object, "rooms", json_object_new_int(count.rooms))
        && pp_json_add(object, "rooms-met", json_object_new_int(count.rooms_met));
    for (int i = 0; i < PP_LOSS_BANDS && good; i++)
        good = pp_json_add(object, bands[i], json_object_new_int(count.losses[i]));
    return pp_json_whole(object, good);
}

enum pp_status pp_assess_table_json(const struct pp_assessments *all, FILE *out,
                                    struct pp_error *err)
{
    struct pp_site_table table;
    enum pp_status status = pp_site_table_of(&table, all->list, all->count, err);
    if (status == PP_OK) {
        struct json_object *object = json_object_new_object();
        bool good =
            object && pp_json_text(object, "format", "pepperpot-site-1")
            && pp_json_add(object, "br209", br209_object(all))
            && add_rows(object, "windows", table.windows, table.window_count, true)
            && add_rows(object, "rooms", table.rooms, table.room_count, true)
            && (table.sun_count == 0
                || add_rows(object, "sunlight", table.suns, table.sun_count, true))
            && (table.garden_count == 0
                || add_rows(object, "gardens", table.gardens, table.garden_count, true))
            && (table.rights_count == 0
                || pp_json_add(object, "rights_of_light", rights_object(&table)))
            && add_others(object, &table)
            && pp_trees_note_json(object, all->list, all->count);
        status = pp_json_print(out, pp_json_whole(object, good), err);
    }
    pp_site_table_clear(&table);
    return status;
}
