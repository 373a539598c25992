/* room_queue.c - each room is one item of the work queue. The result of an item is the
 * simulated columns, as bytes. */
#include "cli/ranks/room_queue.h"

#include <stdlib.h>
#include <string.h>

#include "cli/interrupt.h"
#include "model/base/work_queue.h"
#include "cli/ranks/report_bytes.h"

/* Packs the columns. The first byte states whether the time limit ended the
 * simulation. */
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

/* Simulates one room into a separate report, since results for that room may arrive
 * from another rank in the meantime. */
static enum pp_status simulate_queued_room(void *data, int worker, int room,
                                           char **bytes, size_t *length,
                                           struct pp_error *err)
{
    const struct pp_room_queue *queue = data;
    const struct pp_report *of = queue->figures(queue->data, room).report;
    struct pp_report report = {.world = of->world,
                               .light = of->light,
                               .options = of->options,
                               .receivers = of->receivers,
                               .receiver_count = of->receiver_count,
                               .threads = of->threads,
                               .finished = true};
    bool by_clock = false;
    (void)worker;
    enum pp_status status = queue->simulate(queue->data, room, &report, &by_clock, err);
    if (status == PP_OK)
        status = pack(&report, by_clock, bytes, length, err);
    pp_report_clear(&report);
    return status;
}

static enum pp_status read_room_columns(void *data, int room, const char *bytes,
                                        size_t length, struct pp_error *err)
{
    const struct pp_room_queue *queue = data;
    struct pp_room_figures figures = queue->figures(queue->data, room);
    *figures.by_clock |= bytes[0] != 0;
    return pp_report_bytes_read(figures.report, bytes + 1, length - 1, err);
}

static bool no_interrupt_came(void *data, double done)
{
    (void)data, (void)done;
    return !pp_interrupt_came();
}

/* Simulates all rooms from index `first` in this process alone. */
static enum pp_status alone(const struct pp_room_queue *queue, int first,
                            struct pp_error *err)
{
    enum pp_status status = PP_OK;
    for (int i = first; i < queue->count && status == PP_OK; i++) {
        struct pp_room_figures figures = queue->figures(queue->data, i);
        status = queue->simulate(queue->data, i, figures.report, figures.by_clock, err);
    }
    return status;
}

/* After an interrupt, a room that was not started gets the same result as in a single
 * process, because its simulation stops at once. */
enum pp_status pp_room_queue_run(const struct pp_room_queue *queue,
                                 struct pp_error *err)
{
    int next;
    const struct pp_work_queue rooms = {.end = queue->count,
                                        .threads = 1,
                                        .work = simulate_queued_room,
                                        .collect = read_room_columns,
                                        .goes_on = no_interrupt_came,
                                        .data = (void *)queue,
                                        .ranks = queue->ranks};
    if (!queue->ranks || (queue->count <= 1 && queue->ranks->rank == 0))
        return alone(queue, 0, err);
    if (queue->count <= 1)
        return pp_fail(err, PP_INTERRUPTED,
                       "a single room is simulated on rank 0 alone");
    enum pp_status status = pp_work_queue_run(&rooms, &next, err);
    return status == PP_OK ? alone(queue, next, err) : status;
}
