/* atlas_run.c - rooms wait for those before them, and are then handed over. */
#include "studies/atlas/atlas_run.h"

#include <math.h>
#include <stdlib.h>

#include "model/base/crew.h"

struct rows {
    char *bytes; /* NULL: not done, or handed over */
    size_t length;
};

struct dealing {
    const struct pp_atlas_run *run;
    struct pp_crew *crew;
    struct rows *rooms; /* of the run, from its first */
    int next;           /* to be handed over */
    enum pp_status status;
    struct pp_error err;
};

/* Hands over what has nothing missing before it. */
static void hand_over(struct dealing *dealing)
{
    const struct pp_atlas_run *run = dealing->run;
    while (dealing->status == PP_OK && dealing->next < run->end) {
        struct rows *rows = &dealing->rooms[dealing->next - run->first];
        if (!rows->bytes)
            return;
        dealing->status = run->take(run->to, rows->bytes, rows->length, &dealing->err);
        free(rows->bytes);
        rows->bytes = NULL;
        dealing->next += dealing->status == PP_OK;
    }
}

/* Is the run to go on? */
static bool look(const struct dealing *dealing)
{
    const struct pp_atlas_run *run = dealing->run;
    return !run->watch.look
           || run->watch.look(run->watch.data, (double)dealing->next / run->end, NAN);
}

/* Crew work: room `index`. */
static bool do_room(void *data, int member, int index)
{
    struct dealing *dealing = data;
    const struct pp_atlas_run *run = dealing->run;
    struct rows rows;
    struct pp_error err = {0};
    (void)member;
    enum pp_status status =
        run->rows_of(run->of, index, &rows.bytes, &rows.length, &err);
    pp_crew_lock(dealing->crew);
    if (status == PP_OK) {
        dealing->rooms[index - run->first] = rows;
        hand_over(dealing);
    } else if (dealing->status == PP_OK) {
        dealing->status = status;
        dealing->err = err;
    }
    bool more = dealing->status == PP_OK && look(dealing);
    pp_crew_unlock(dealing->crew);
    return more;
}

enum pp_status pp_atlas_run(const struct pp_atlas_run *run, int *next,
                            struct pp_error *err)
{
    struct dealing dealing = {.run = run, .next = run->first};
    *next = run->first;
    if (run->end <= run->first)
        return PP_OK;
    size_t count = (size_t)(run->end - run->first);
    dealing.rooms = calloc(count, sizeof *dealing.rooms);
    if (!dealing.rooms)
        return pp_fail_memory(err);
    dealing.status = pp_crew_create(&dealing.crew, run->threads, &dealing.err);
    if (dealing.status == PP_OK) {
        if (run->watch.begin)
            run->watch.begin(run->watch.data, "atlas");
        pp_crew_run(dealing.crew, run->first, run->end, do_room, &dealing);
        if (run->watch.end)
            run->watch.end(run->watch.data);
    }
    for (size_t i = 0; i < count; i++)
        free(dealing.rooms[i].bytes);
    free(dealing.rooms);
    pp_crew_destroy(dealing.crew);
    *next = dealing.next;
    if (dealing.status != PP_OK && err)
        *err = dealing.err;
    return dealing.status;
}
