/* atlas_drawn.c - reads the text of a room of the atlas and makes the report of all
 * hand methods. */
#include "studies/research/atlas/atlas_drawn.h"

#include <string.h>

#include "model/room/building.h"
#include "model/room/room_light.h"
#include "studies/study_report.h"

static enum pp_status fail_room(struct pp_error *err, int index,
                                const struct pp_mistakes *mistakes)
{
    return pp_fail(err, PP_BAD_INPUT, "room %d of the atlas is not valid: %s", index,
                   mistakes->count > 0 ? mistakes->list[0].text : err->message);
}

static enum pp_status read_room(struct pp_atlas_drawn *drawn,
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

void pp_atlas_drawn_clear(struct pp_atlas_drawn *drawn)
{
    pp_report_clear(&drawn->report);
    pp_study_room_clear(&drawn->room);
    pp_building_destroy(drawn->building);
}

enum pp_status pp_atlas_drawn_room(struct pp_atlas_drawn *drawn,
                                   const struct pp_atlas_design *design, int index,
                                   const struct pp_atlas_trace *trace,
                                   struct pp_error *err)
{
    struct pp_mistakes mistakes;
    *drawn = (struct pp_atlas_drawn){.options = {.methods = "all",
                                                 .simulate = true,
                                                 .error = trace->error,
                                                 .seed = trace->seed + (uint64_t)index,
                                                 .threads = 1,
                                                 .alone = true}};
    pp_mistakes_init(&mistakes, "atlas");
    enum pp_status status = read_room(drawn, design, index, &mistakes, err);
    pp_mistakes_clear(&mistakes);
    if (status == PP_OK)
        status =
            pp_study_report_methods(&drawn->report, &drawn->room, &drawn->options, err);
    return status;
}
