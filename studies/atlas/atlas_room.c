/* atlas_room.c - from a room's text to its rows. */
#include "studies/atlas/atlas_room.h"

#include <stdlib.h>
#include <string.h>

#include "model/room/building.h"
#include "model/room/room_light.h"
#include "studies/study_report.h"

/* A room of the sweep, read; its methods' report. */
struct drawn {
    struct pp_building *building;
    struct pp_study_room room;
    struct pp_study_options options;
    struct pp_report report;
};

static enum pp_status fail_room(struct pp_error *err, int index,
                                const struct pp_mistakes *mistakes)
{
    return pp_fail(err, PP_BAD_INPUT, "room %d of the atlas makes no sense: %s", index,
                   mistakes->count > 0 ? mistakes->list[0].text : err->message);
}

static enum pp_status read_room(struct drawn *drawn,
                                const struct pp_atlas_design *design, int index,
                                struct pp_mistakes *mistakes, struct pp_error *err)
{
    char xml[PP_ATLAS_XML];
    struct pp_world *world = NULL;
    struct pp_outside_light light;
    pp_atlas_design_room(design, (uint32_t)index, xml);
    enum pp_status status =
        pp_building_parse(&drawn->building, xml, strlen(xml), mistakes, err);
    struct pp_room *room =
        status == PP_OK ? pp_building_room(drawn->building, 0) : NULL;
    if (status == PP_OK)
        status = pp_world_create(&world, room, mistakes, err);
    if (status == PP_OK)
        status = pp_room_light(&light, room, err);
    if (status == PP_OK)
        pp_study_room_init(&drawn->room, "atlas", drawn->building, 0, room, world,
                           &light);
    else
        pp_world_destroy(world);
    return status == PP_BAD_INPUT ? fail_room(err, index, mistakes) : status;
}

static void clear(struct drawn *drawn)
{
    pp_report_clear(&drawn->report);
    pp_study_room_clear(&drawn->room);
    pp_building_destroy(drawn->building);
}

/* Reads the room and asks the methods. */
static enum pp_status evaluate(struct drawn *drawn,
                               const struct pp_atlas_design *design, int index,
                               const struct pp_atlas_trace *trace, struct pp_error *err)
{
    struct pp_mistakes mistakes;
    *drawn = (struct drawn){.options = {.methods = "all",
                                        .simulate = true,
                                        .error = trace->error,
                                        .seed = trace->seed + (uint64_t)index,
                                        .threads = 1}};
    pp_mistakes_init(&mistakes, "atlas");
    enum pp_status status = read_room(drawn, design, index, &mistakes, err);
    pp_mistakes_clear(&mistakes);
    if (status == PP_OK)
        status =
            pp_study_report_methods(&drawn->report, &drawn->room, &drawn->options, err);
    return status;
}

enum pp_status pp_atlas_room_columns(struct pp_atlas_columns *columns,
                                     const struct pp_atlas_design *design,
                                     struct pp_error *err)
{
    struct drawn drawn;
    const struct pp_atlas_trace none = {0};
    enum pp_status status = evaluate(&drawn, design, 0, &none, err);
    if (status == PP_OK)
        status = pp_atlas_columns_of(columns, &drawn.report, err);
    clear(&drawn);
    return status;
}

/* Traces the room and the worlds of its methods. */
static enum pp_status trace_all(struct drawn *drawn, struct pp_own_worlds *worlds,
                                struct pp_error *err)
{
    bool finished = true, by_clock = false;
    enum pp_status status =
        pp_study_report_traced(&drawn->report, &drawn->options, &by_clock, err);
    if (status == PP_OK)
        status = pp_own_world_trace(worlds, &drawn->options, &finished, &by_clock, err);
    return status;
}

static enum pp_status print(char **rows, size_t *length, const struct drawn *drawn,
                            const struct pp_atlas_columns *columns, int index,
                            const struct pp_own_worlds *worlds, struct pp_error *err)
{
    FILE *out = open_memstream(rows, length);
    if (!out)
        return pp_fail_memory(err);
    enum pp_status status =
        pp_atlas_columns_print_room(columns, index, &drawn->report, worlds, out, err);
    if (fclose(out) != 0 && status == PP_OK)
        status = pp_fail_memory(err);
    return status;
}

enum pp_status pp_atlas_room_rows(char **rows, size_t *length,
                                  const struct pp_atlas_columns *columns,
                                  const struct pp_atlas_design *design, int index,
                                  const struct pp_atlas_trace *trace,
                                  struct pp_error *err)
{
    struct drawn drawn;
    struct pp_own_worlds *worlds = NULL;
    *rows = NULL;
    enum pp_status status = evaluate(&drawn, design, index, trace, err);
    if (status == PP_OK)
        status = pp_own_world_list(&worlds, drawn.room.room, &drawn.report, err);
    if (status == PP_OK)
        status = trace_all(&drawn, worlds, err);
    if (status == PP_OK)
        status = print(rows, length, &drawn, columns, index, worlds, err);
    if (status != PP_OK) {
        free(*rows);
        *rows = NULL;
    }
    pp_own_world_destroy(worlds);
    clear(&drawn);
    return status;
}
