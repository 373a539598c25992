/* deal_rooms.c - one room a deal; what is sent are the simulation's columns. */
#include "cli/ranks/deal_rooms.h"

#include <stdlib.h>
#include <string.h>

#include "cli/interrupt.h"
#include "model/base/deal.h"
#include "cli/ranks/report_bytes.h"

/* The first byte is whether the time was over. */
static enum pp_status pack(const struct pp_report *report, bool by_clock, char **bytes,
                           size_t *length, struct pp_error *err)
{
    char *columns;
    enum pp_status status = pp_report_bytes_write(report, &columns, length, err);
    if (status != PP_OK)
        return status;
    *bytes = malloc(*length + 1);
    if (*bytes) {
        **bytes = by_clock;
        memcpy(*bytes + 1, columns, *length);
        ++*length;
    }
    free(columns);
    return *bytes ? PP_OK : pp_fail_memory(err);
}

/* In a report of its own, as another rank's figures of the room may come meanwhile. */
static enum pp_status work(void *data, int worker, int room, char **bytes,
                           size_t *length, struct pp_error *err)
{
    const struct pp_room_dealing *dealing = data;
    const struct pp_report *of = dealing->figures(dealing->data, room).report;
    struct pp_report report = {.world = of->world,
                               .light = of->light,
                               .options = of->options,
                               .receivers = of->receivers,
                               .receiver_count = of->receiver_count,
                               .threads = of->threads,
                               .finished = true};
    bool by_clock = false;
    (void)worker;
    enum pp_status status =
        dealing->simulate(dealing->data, room, &report, &by_clock, err);
    if (status == PP_OK)
        status = pack(&report, by_clock, bytes, length, err);
    pp_report_clear(&report);
    return status;
}

static enum pp_status take(void *data, int room, const char *bytes, size_t length,
                           struct pp_error *err)
{
    const struct pp_room_dealing *dealing = data;
    struct pp_room_figures figures = dealing->figures(dealing->data, room);
    *figures.by_clock |= bytes[0] != 0;
    return pp_report_bytes_read(figures.report, bytes + 1, length - 1, err);
}

static bool look(void *data, double done)
{
    (void)data, (void)done;
    return !pp_interrupt_came();
}

/* Those from `first` on, by this process. */
static enum pp_status alone(const struct pp_room_dealing *dealing, int first,
                            struct pp_error *err)
{
    enum pp_status status = PP_OK;
    for (int i = first; i < dealing->count && status == PP_OK; i++) {
        struct pp_room_figures figures = dealing->figures(dealing->data, i);
        status =
            dealing->simulate(dealing->data, i, figures.report, figures.by_clock, err);
    }
    return status;
}

/* After a stop, rooms that were not taken get what a process alone has of them: the watch
 * of the simulation ends each as soon as it has begun. */
enum pp_status pp_deal_rooms(const struct pp_room_dealing *dealing,
                             struct pp_error *err)
{
    int next;
    const struct pp_deal deal = {.end = dealing->count,
                                 .threads = 1,
                                 .work = work,
                                 .take = take,
                                 .look = look,
                                 .data = (void *)dealing,
                                 .ranks = dealing->ranks};
    if (!dealing->ranks || (dealing->count <= 1 && dealing->ranks->rank == 0))
        return alone(dealing, 0, err);
    if (dealing->count <= 1)
        return pp_fail(err, PP_INTERRUPTED, "one room is rank 0's");
    enum pp_status status = pp_deal_run(&deal, &next, err);
    return status == PP_OK ? alone(dealing, next, err) : status;
}
