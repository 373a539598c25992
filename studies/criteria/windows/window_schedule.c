/* window_schedule.c - see window_schedule.h. */
#include "studies/criteria/windows/window_schedule.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/array.h"
#include "studies/criteria/site_table.h"

static const char *const titles[PP_SCHEDULE_CHANGES] = {
    "vertical sky component, %", "annual sunlight hours, %", "winter sunlight hours, %",
    "area with a view of the sky, m²",
    "vertical sky component without the building's own balconies, %"};

double pp_schedule_loss(struct pp_schedule_change change)
{
    return 1.0 - pp_schedule_ratio(change);
}

double pp_schedule_ratio(struct pp_schedule_change change)
{
    return change.existing > 0.0 ? change.proposed / change.existing : NAN;
}

double pp_schedule_scale(enum pp_schedule_quantity quantity)
{
    return quantity == PP_SCHEDULE_AREA ? 1.0 : 100.0;
}

/* The row of that window, which is added if it does not exist; NULL: out of memory. */
static struct pp_schedule_row *row_of(struct pp_window_schedule *schedule,
                                      const struct pp_assessment *room, int line,
                                      struct pp_error *err)
{
    const struct pp_world *world = room->room->world;
    const char *label = pp_world_label(world, line);
    for (int i = schedule->count - 1; i >= 0; i--)
        if (schedule->rows[i].room == room
            && strcmp(schedule->rows[i].window, label) == 0)
            return &schedule->rows[i];
    if (pp_array_append(&schedule->rows, schedule->count, sizeof *schedule->rows, err)
        != PP_OK)
        return NULL;
    struct pp_schedule_row *row = &schedule->rows[schedule->count++];
    *row = (struct pp_schedule_row){.room = room,
                                    .window = label,
                                    .level_m = world->placement.z,
                                    .verdict = PP_NOT_JUDGED};
    for (int i = 0; i < PP_SCHEDULE_CHANGES; i++)
        row->changes[i] = (struct pp_schedule_change){NAN, NAN, NAN};
    return row;
}

static enum pp_status add_change(struct pp_window_schedule *schedule,
                                 const struct pp_site_row *of,
                                 enum pp_schedule_quantity quantity,
                                 struct pp_error *err)
{
    struct pp_schedule_row *row = row_of(schedule, of->room, of->finding->line, err);
    if (!row)
        return PP_SYSTEM;
    row->changes[quantity] =
        (struct pp_schedule_change){of->existing, of->proposed, of->cumulative};
    if (quantity == PP_SCHEDULE_SKY) {
        const struct pp_finding *cumulative = of->in_cumulative;
        row->verdict = of->finding->verdict;
        row->changes[PP_SCHEDULE_BARE] = (struct pp_schedule_change){
            of->finding->before_unshaded, of->finding->now_unshaded,
            cumulative ? cumulative->now_unshaded : NAN};
    }
    return PP_OK;
}

static bool is_of_winter(const struct pp_finding *finding)
{
    return finding->season && strcmp(finding->season, "winter") == 0;
}

enum pp_status pp_window_schedule_of(struct pp_window_schedule *schedule,
                                     const struct pp_assessment *rooms, int count,
                                     struct pp_error *err)
{
    struct pp_site_table table;
    *schedule = (struct pp_window_schedule){0};
    enum pp_status status = pp_site_table_of(&table, rooms, count, err);
    for (int i = 0; i < table.window_count && status == PP_OK; i++)
        status = add_change(schedule, &table.windows[i], PP_SCHEDULE_SKY, err);
    for (int i = 0; i < table.sun_count && status == PP_OK; i++)
        status = add_change(schedule, &table.suns[i],
                            is_of_winter(table.suns[i].finding) ? PP_SCHEDULE_WINTER
                                                                : PP_SCHEDULE_YEAR,
                            err);
    for (int i = 0; i < schedule->count && status == PP_OK; i++)
        for (int k = 0; k < table.room_count; k++)
            if (table.rooms[k].room == schedule->rows[i].room)
                schedule->rows[i].changes[PP_SCHEDULE_AREA] =
                    (struct pp_schedule_change){table.rooms[k].existing,
                                                table.rooms[k].proposed,
                                                table.rooms[k].cumulative};
    schedule->has_cumulative = table.has_cumulative;
    schedule->probable = table.sun_count > 0 && !isnan(table.suns[0].finding->wanted);
    pp_site_table_clear(&table);
    return status;
}

void pp_window_schedule_clear(struct pp_window_schedule *schedule)
{
    free(schedule->rows);
    *schedule = (struct pp_window_schedule){0};
}

void pp_window_schedule_title(char title[PP_SCHEDULE_TITLE],
                              const struct pp_window_schedule *schedule,
                              enum pp_schedule_quantity quantity)
{
    const bool is_sun = quantity == PP_SCHEDULE_YEAR || quantity == PP_SCHEDULE_WINTER;
    snprintf(title, PP_SCHEDULE_TITLE, "%s%s",
             !is_sun              ? ""
             : schedule->probable ? "probable "
                                  : "possible ",
             titles[quantity]);
}
