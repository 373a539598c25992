/* site_table.c - sorts findings into windows, rooms, sunlight, gardens, rights of light
 * and others.
 *
 * If the former state of a room is given, its windows are listed with the criterion
 * that compares both states (former-sky), otherwise with the one for the present state
 * (vertical-sky). Values with the building's mirror image are added to the same lines.
 */
#include "studies/criteria/site_table.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/array.h"

/* The same finding of the room in the cumulative state; NULL: none. */
static const struct pp_finding *find_cumulative(const struct pp_assessment *room,
                                                const struct pp_answer *answer,
                                                const struct pp_finding *finding)
{
    const struct pp_answer_list *answers = &room->cumulative_answers;
    const long index = finding - answer->findings.list;
    for (int i = 0; i < answers->count; i++)
        if (answers->list[i].criterion == answer->criterion
            && index < answers->list[i].findings.count
            && strcmp(answers->list[i].findings.list[index].what, finding->what) == 0)
            return &answers->list[i].findings.list[index];
    return NULL;
}

static enum pp_status add_site_row(struct pp_site_row **rows, int *count,
                                   const struct pp_assessment *room,
                                   const struct pp_answer *answer,
                                   const struct pp_finding *finding,
                                   struct pp_error *err)
{
    if (pp_array_append(rows, *count, sizeof **rows, err) != PP_OK)
        return PP_SYSTEM;
    double before = finding->before;
    const struct pp_finding *in_cumulative = find_cumulative(room, answer, finding);
    double cumulative = in_cumulative ? in_cumulative->now : NAN;
    (*rows)[(*count)++] = (struct pp_site_row){
        .room = room,
        .criterion = answer->criterion,
        .finding = finding,
        .existing = before,
        .proposed = finding->now,
        .ratio = before > 0.0 ? finding->now / before : NAN,
        .cumulative = cumulative,
        .cumulative_ratio = before > 0.0 ? cumulative / before : NAN,
        .in_cumulative = in_cumulative,
        .mirrored = NAN};
    return PP_OK;
}

/* Adds a value with the mirror image to the line of its window or room; false if there
 * is no such line. */
static bool put_beside(struct pp_site_table *table, const struct pp_assessment *room,
                       const struct pp_finding *finding)
{
    const bool of_window = finding->line > 0;
    struct pp_site_row *rows = of_window ? table->windows : table->rooms;
    const int count = of_window ? table->window_count : table->room_count;
    for (int i = 0; i < count; i++) {
        if (rows[i].room != room
            || (of_window && strcmp(rows[i].finding->what, finding->what) != 0))
            continue;
        rows[i].mirrored = finding->wanted;
        rows[i].by_mirror_image = finding;
        table->has_mirror_image = true;
        return true;
    }
    return false;
}

/* True if the room has findings by that criterion. */
static bool has(const struct pp_assessment *room, const struct pp_criterion *criterion)
{
    for (int i = 0; i < room->answers.count; i++)
        if (room->answers.list[i].criterion == criterion)
            return true;
    return false;
}

/* Adds the line of a room: the first finding with a verdict or, if none has one, the
 * first finding. */
static enum pp_status add_rights(struct pp_site_table *table,
                                 const struct pp_assessment *room,
                                 const struct pp_answer *answer, struct pp_error *err)
{
    const struct pp_finding_list *findings = &answer->findings;
    const struct pp_finding *judged = findings->list;
    for (int i = 0; i < findings->count; i++)
        if (pp_finding_verdict(findings->list[i].verdict)) {
            judged = &findings->list[i];
            break;
        }
    if (findings->count == 0)
        return PP_OK;
    enum pp_status status =
        add_site_row(&table->rights, &table->rights_count, room, answer, judged, err);
    if (status != PP_OK || !(findings->lit.plane_m2 > 0.0))
        return status;
    struct pp_site_row *row = &table->rights[table->rights_count - 1];
    row->lit = &findings->lit;
    row->existing = findings->lit.before_m2;
    row->proposed = findings->lit.lit_m2;
    row->ratio = row->existing > 0.0 ? row->proposed / row->existing : NAN;
    pp_lit_area_add(&table->rights_sum, &findings->lit);
    return PP_OK;
}

static enum pp_status add_answer(struct pp_site_table *table,
                                 const struct pp_assessment *room,
                                 const struct pp_answer *answer, struct pp_error *err)
{
    const struct pp_criterion *criterion = answer->criterion;
    const struct pp_finding_list *findings = &answer->findings;
    bool of_sky = criterion == &pp_criterion_vertical_sky
                  || criterion == &pp_criterion_former_sky;
    if (criterion == &pp_criterion_vertical_sky && has(room, &pp_criterion_former_sky))
        return PP_OK;
    /* The last finding of the no-sky line is the one that compares both states, if
     * there is one. */
    if (criterion == &pp_criterion_no_sky_line)
        return findings->count == 0
                   ? PP_OK
                   : add_site_row(&table->rooms, &table->room_count, room, answer,
                                  &findings->list[findings->count - 1], err);
    if (criterion == &pp_criterion_rights_of_light)
        return add_rights(table, room, answer, err);
    for (int i = 0; i < findings->count; i++) {
        if (criterion == &pp_criterion_mirror_image
            && put_beside(table, room, &findings->list[i]))
            continue;
        if (criterion == &pp_criterion_sunlight && isfinite(findings->list[i].now)) {
            if (add_site_row(&table->suns, &table->sun_count, room, answer,
                             &findings->list[i], err)
                != PP_OK)
                return PP_SYSTEM;
            continue;
        }
        if (criterion == &pp_criterion_gardens) {
            if (add_site_row(&table->gardens, &table->garden_count, room, answer,
                             &findings->list[i], err)
                != PP_OK)
                return PP_SYSTEM;
            continue;
        }
        enum pp_status status =
            of_sky ? add_site_row(&table->windows, &table->window_count, room, answer,
                                  &findings->list[i], err)
                   : add_site_row(&table->others, &table->other_count, room, answer,
                                  &findings->list[i], err);
        if (status != PP_OK)
            return status;
    }
    return PP_OK;
}

enum pp_status pp_site_table_of(struct pp_site_table *table,
                                const struct pp_assessment *rooms, int count,
                                struct pp_error *err)
{
    *table = (struct pp_site_table){.rights_sum = pp_lit_area_change(NAN, NAN, NAN)};
    enum pp_status status = PP_OK;
    for (int is_new = 0; is_new < 2; is_new++)
        for (int i = 0; i < count; i++)
            for (int k = 0; k < rooms[i].answers.count && status == PP_OK; k++)
                if (rooms[i].is_new == (is_new != 0))
                    status =
                        add_answer(table, &rooms[i], &rooms[i].answers.list[k], err);
    for (int i = 0; i < count; i++)
        table->has_cumulative |= rooms[i].cumulative != NULL;
    return status;
}

const char *pp_site_table_sun_title(const struct pp_site_table *table)
{
    bool judged = table->sun_count > 0 && !isnan(table->suns[0].finding->wanted);
    return judged ? "Sunlight hours, probable" : "Sunlight hours, possible";
}

int pp_site_table_existing(const struct pp_site_row *rows, int count)
{
    int existing = 0;
    while (existing < count && !rows[existing].room->is_new)
        existing++;
    return existing;
}

void pp_site_table_clear(struct pp_site_table *table)
{
    free(table->windows);
    free(table->rooms);
    free(table->suns);
    free(table->gardens);
    free(table->rights);
    free(table->others);
    *table = (struct pp_site_table){0};
}
