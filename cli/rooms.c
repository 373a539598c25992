/* rooms.c - reads room files, resolves their rooms, and sets the points. */
#include "cli/rooms.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/message.h"
#include "model/base/array.h"
#include "model/base/text.h"
#include "model/room/building.h"
#include "model/room/room.h"
#include "model/room/room_light.h"
#include "model/room/position.h"
#include "studies/doubts.h"

/* State of the loader between files. */
struct loading {
    struct pp_rooms *rooms;
    const char *command;
    const struct pp_room_options *options;
};

static enum pp_exit add_world(struct loading *loading, const char *file,
                              struct pp_building *building, int index,
                              struct pp_world *world,
                              const struct pp_outside_light *light)
{
    struct pp_rooms *rooms = loading->rooms;
    struct pp_error err;
    if (pp_array_append(&rooms->list, rooms->count, sizeof *rooms->list, &err)
        != PP_OK) {
        pp_world_destroy(world);
        return pp_message_error(&err);
    }
    pp_study_room_init(&rooms->list[rooms->count++], file, building, index,
                       pp_building_room(building, index), world, light);
    return PP_EXIT_DONE;
}

/* Resolves one room of a file. Errors in the room are added to `mistakes`. */
static enum pp_exit resolve_room(struct loading *loading, const char *file,
                                 struct pp_building *building, int index,
                                 struct pp_mistakes *mistakes)
{
    struct pp_room *room = pp_building_room(building, index);
    struct pp_error err = {0};
    const char *sky = loading->options->study.sky;
    bool shared = sky && index > 0 && strncmp(sky, "picture,", 8) == 0;
    if (shared) { /* the picture is read only once for all rooms of the file */
        pp_room_take_sky(room, pp_building_room(building, 0));
    } else if (sky && pp_room_set_sky(room, sky, &err) != PP_OK) {
        struct pp_error usage;
        pp_fail(&usage, PP_BAD_INPUT, "--sky: %s", err.message);
        return err.status == PP_BAD_INPUT ? pp_message_usage(loading->command, &usage)
                                          : pp_message_error(&err);
    }

    if (loading->options->plane_m > 0.0)
        pp_room_set_working_plane(room, loading->options->plane_m);
    struct pp_world *world = NULL;
    enum pp_status status = pp_world_create(&world, room, mistakes, &err);
    if (status == PP_BAD_INPUT && mistakes->count > 0)
        return PP_EXIT_DONE; /* errors are reported later, with the other errors in the
                              * file */
    struct pp_outside_light light;
    if (status == PP_OK)
        status = pp_room_light(&light, room, &err);
    if (status != PP_OK) {
        pp_world_destroy(world);
        return pp_message_error(&err);
    }
    return add_world(loading, file, building, index, world, &light);
}

/* Transfers ownership of the building to *rooms. building may be NULL. */
static enum pp_exit keep_building(struct pp_rooms *rooms, struct pp_building *building)
{
    struct pp_error err;
    if (pp_array_append(&rooms->buildings, rooms->building_count,
                        sizeof *rooms->buildings, &err)
        != PP_OK) {
        pp_building_destroy(building);
        return pp_message_error(&err);
    }
    rooms->buildings[rooms->building_count++] = building;
    return PP_EXIT_DONE;
}

/* Sets the building to the requested state. In this state it must have at least one
 * room. */
static enum pp_status choose_state(struct pp_building *building, const char *file,
                                   enum pp_site_state state, struct pp_error *err)
{
    if (state != PP_STATE_BOTH && !pp_building_has_states(building))
        return pp_fail(err, PP_BAD_INPUT,
                       "%s: --state: no element in the file has a state; expected a "
                       "file with existing and proposed states",
                       file);
    if (state != PP_STATE_BOTH && pp_building_set_state(building, state, err) != PP_OK)
        return PP_SYSTEM;
    if (pp_building_room_count(building) == 0)
        return pp_fail(err, PP_BAD_INPUT,
                       "%s: the file has no %s room; expected at least one", file,
                       state == PP_STATE_EXISTING     ? "existing"
                       : state == PP_STATE_CUMULATIVE ? "cumulative"
                                                      : "proposed");
    return PP_OK;
}

/* Resolves all rooms of a building that has been read. */
static enum pp_exit resolve_building(struct loading *loading, const char *file,
                                     struct pp_building *building,
                                     struct pp_mistakes *mistakes)
{
    int count = pp_building_room_count(building);
    enum pp_exit result = PP_EXIT_DONE;
    for (int i = 0; i < count && result == PP_EXIT_DONE; i++)
        result = resolve_room(loading, file, building, i, mistakes);
    loading->rooms->several |= pp_building_name(building) || count > 1;
    return result;
}

static enum pp_exit load_file(struct loading *loading, const char *file)
{
    struct pp_mistakes mistakes;
    pp_mistakes_init(&mistakes, strcmp(file, "-") == 0 ? "standard input" : file);
    struct pp_error err = {0};
    struct pp_building *building = NULL;
    enum pp_status status = pp_building_read_changed(
        &building, file, &loading->options->sweep.now, &mistakes, &err);

    enum pp_exit result = PP_EXIT_DONE;
    if (status != PP_OK && (status != PP_BAD_INPUT || mistakes.count == 0))
        result = pp_message_error(&err);
    enum pp_exit kept = keep_building(loading->rooms, building);
    if (kept != PP_EXIT_DONE) {
        pp_mistakes_clear(&mistakes);
        return kept;
    }
    if (building && result == PP_EXIT_DONE
        && choose_state(building, file, loading->options->state, &err) != PP_OK)
        result = pp_message_error(&err);
    if (building && result == PP_EXIT_DONE)
        result = resolve_building(loading, file, building, &mistakes);
    if (mistakes.count > 0 && result == PP_EXIT_DONE)
        result = pp_message_mistakes(&mistakes);
    pp_mistakes_clear(&mistakes);
    return result;
}

/* Collects warnings about doubtful input in all rooms. */
static enum pp_exit find_doubts(struct pp_rooms *rooms)
{
    struct pp_error err;
    rooms->doubts = calloc((size_t)rooms->count + 1, sizeof *rooms->doubts);
    for (int i = 0; i < rooms->count && rooms->doubts; i++) {
        struct pp_mistakes *doubts = pp_mistakes_create(rooms->list[i].file);
        if (!doubts)
            return pp_fail_memory(&err), pp_message_error(&err);
        rooms->doubts[rooms->doubt_count++] = doubts;
        pp_doubts_find(doubts, rooms->list[i].world,
                       pp_building_room_count(rooms->list[i].building) == 1);
        rooms->list[i].doubts = doubts;
    }
    if (rooms->doubts)
        return PP_EXIT_DONE;
    return pp_fail_memory(&err), pp_message_error(&err);
}

/* Reports the warnings. A warning that several rooms of a file have in common is
 * reported once. strict: warnings are errors. */
static enum pp_exit report_doubts(const struct pp_rooms *rooms, bool strict)
{
    int count = 0;
    for (int i = 0; i < rooms->count;) {
        struct pp_mistakes all;
        const char *file = rooms->list[i].file;
        pp_mistakes_init(&all, strcmp(file, "-") == 0 ? "standard input" : file);
        for (; i < rooms->count && rooms->list[i].file == file; i++) {
            const struct pp_mistakes *own = rooms->list[i].doubts;
            for (int k = 0; k < own->count; k++)
                pp_mistakes_add(&all, own->list[k].line, "%s", own->list[k].text);
        }
        count += all.count;
        pp_message_warnings(&all, strict);
        pp_mistakes_clear(&all);
    }
    return strict && count > 0 ? PP_EXIT_INPUT : PP_EXIT_DONE;
}

/* Sets the points of --points in this room; they face up. */
static enum pp_exit place_points(struct pp_study_room *room,
                                 const struct pp_point_list *points)
{
    struct pp_error err;
    struct pp_receiver *receivers = calloc((size_t)points->count, sizeof *receivers);
    if (!receivers) {
        pp_fail_memory(&err);
        return pp_message_error(&err);
    }
    pp_study_room_set_points(room, receivers, points->count);
    for (int i = 0; i < points->count; i++) {
        struct pp_error own = {0};
        const char *name = room->world->name;
        if (pp_position_place_receiver(&receivers[i], room->world, points->list[i],
                                       &own)
            == PP_OK)
            continue;
        pp_fail(&err, PP_BAD_INPUT, "%s%s%.100s: --points: %s", room->file,
                name ? ", " : "", name ? name : "", own.message);
        return pp_message_error(&err);
    }
    return PP_EXIT_DONE;
}

static enum pp_exit say_no_such_room(const struct pp_rooms *rooms, const char *wanted)
{
    struct pp_error err;
    const char **names = calloc((size_t)rooms->count + 1, sizeof *names);
    if (!names) {
        pp_fail_memory(&err);
        return pp_message_error(&err);
    }
    int count = 0;
    for (int i = 0; i < rooms->count; i++)
        if (rooms->list[i].world->name)
            names[count++] = rooms->list[i].world->name;
    char known[512], question[512];
    pp_text_did_you_mean(question, sizeof question, "\"",
                         pp_text_nearest(wanted, names, count), "\"");
    if (question[0])
        pp_fail(&err, PP_BAD_INPUT, "no room is named \"%.200s\"; %s", wanted,
                question);
    else
        pp_fail(&err, PP_BAD_INPUT, "no room is named \"%.200s\"; expected %s", wanted,
                pp_text_list_names(known, sizeof known, names, count));
    free(names);
    return pp_message_error(&err);
}

/* Removes all rooms with other names. */
static enum pp_exit choose_room(struct pp_rooms *rooms, const char *wanted)
{
    int kept = 0;
    for (int i = 0; i < rooms->count; i++) {
        const char *name = rooms->list[i].world->name;
        kept += name && strcmp(name, wanted) == 0;
    }
    if (kept == 0)
        return say_no_such_room(rooms, wanted);
    kept = 0;
    for (int i = 0; i < rooms->count; i++) {
        const char *name = rooms->list[i].world->name;
        if (name && strcmp(name, wanted) == 0)
            rooms->list[kept++] = rooms->list[i];
        else
            pp_study_room_clear(&rooms->list[i]);
    }
    rooms->count = kept;
    return PP_EXIT_DONE;
}

enum pp_exit pp_rooms_load(struct pp_rooms *rooms, const char *command, char **files,
                           int file_count, const struct pp_room_options *options)
{
    *rooms = (struct pp_rooms){.several = file_count > 1,
                               .more_than_one_file = file_count > 1};
    struct loading loading = {rooms, command, options};

    /* A system error stops the loop; input errors are reported for all files. */
    enum pp_exit result = PP_EXIT_DONE;
    for (int i = 0; i < file_count; i++) {
        enum pp_exit of_file = load_file(&loading, files[i]);
        if (of_file != PP_EXIT_DONE)
            result = of_file;
        if (of_file > PP_EXIT_INPUT)
            break;
    }
    if (result == PP_EXIT_DONE && options->room)
        result = choose_room(rooms, options->room);
    for (int i = 0; i < rooms->count && result == PP_EXIT_DONE; i++)
        if (options->study.points.count > 0)
            result = place_points(&rooms->list[i], &options->study.points);
    if (result == PP_EXIT_DONE)
        result = find_doubts(rooms);
    if (result == PP_EXIT_DONE)
        result = report_doubts(rooms, options->study.strict);
    if (result != PP_EXIT_DONE)
        pp_rooms_clear(rooms);
    return result;
}

/* Sets the building to the state. If `line` is not NULL, instead keeps the parts that
 * exist in both states and adds the mirror image of the placed rooms about that
 * line. */
static enum pp_status settle_again(struct pp_building *building,
                                   enum pp_site_state state,
                                   const struct pp_mirror_line *line,
                                   struct pp_error *err)
{
    struct pp_error why = {0};
    if (!line)
        return pp_building_set_state(building, state, err);
    enum pp_status status = pp_building_mirror(building, line, &why);
    return status == PP_OK ? PP_OK
                           : pp_fail(err, status, "--mirror-image: %s", why.message);
}

/* Parses the proposed building again from its text, then sets the state or the mirror
 * image. */
static enum pp_exit load_again(struct loading *loading, const char *file,
                               const struct pp_building *proposed,
                               enum pp_site_state state,
                               const struct pp_mirror_line *line)
{
    struct pp_mistakes mistakes;
    struct pp_building *building = NULL;
    struct pp_error err = {0};
    pp_mistakes_init(&mistakes, strcmp(file, "-") == 0 ? "standard input" : file);
    enum pp_status status =
        pp_building_read_again(&building, proposed, &mistakes, &err);
    if (status == PP_OK)
        status = settle_again(building, state, line, &err);
    enum pp_exit result = status == PP_OK ? PP_EXIT_DONE : pp_message_error(&err);
    enum pp_exit kept = keep_building(loading->rooms, building);
    if (result == PP_EXIT_DONE)
        result = kept;
    if (result == PP_EXIT_DONE)
        result = resolve_building(loading, file, building, &mistakes);
    if (mistakes.count > 0 && result == PP_EXIT_DONE)
        result = pp_message_mistakes(&mistakes);
    pp_mistakes_clear(&mistakes);
    return result;
}

static bool has_state(const struct pp_building *building, enum pp_site_state state)
{
    return state == PP_STATE_CUMULATIVE ? pp_building_has_cumulative(building)
                                        : pp_building_has_states(building);
}

/* Parses again every building that has the state, and sets that state, or the mirror
 * image if `line` is not NULL. */
static enum pp_exit load_all_again(struct pp_rooms *rooms, const char *command,
                                   const struct pp_rooms *proposed,
                                   const struct pp_room_options *options,
                                   enum pp_site_state state,
                                   const struct pp_mirror_line *line)
{
    *rooms = (struct pp_rooms){.more_than_one_file = proposed->more_than_one_file};
    struct loading loading = {rooms, command, options};
    enum pp_exit result = PP_EXIT_DONE;
    const struct pp_building *last = NULL;
    for (int i = 0; i < proposed->count && result == PP_EXIT_DONE; i++) {
        const struct pp_study_room *room = &proposed->list[i];
        if (room->building == last || !has_state(room->building, state))
            continue;
        last = room->building;
        result = load_again(&loading, room->file, last, state, line);
    }
    if (result != PP_EXIT_DONE)
        pp_rooms_clear(rooms);
    return result;
}

enum pp_exit pp_rooms_load_state(struct pp_rooms *rooms, const char *command,
                                 const struct pp_rooms *proposed,
                                 const struct pp_room_options *options,
                                 enum pp_site_state state)
{
    return load_all_again(rooms, command, proposed, options, state, NULL);
}

enum pp_exit pp_rooms_load_mirrored(struct pp_rooms *rooms, const char *command,
                                    const struct pp_rooms *proposed,
                                    const struct pp_room_options *options,
                                    const struct pp_mirror_line *line)
{
    struct pp_error err;
    for (int i = 0; i < proposed->count; i++) {
        if (pp_building_has_states(proposed->list[i].building))
            continue;
        pp_fail(&err, PP_BAD_INPUT,
                "%s: --mirror-image: no element in the file has a state; expected a "
                "file with existing and proposed states",
                proposed->list[i].file);
        return pp_message_error(&err);
    }
    return load_all_again(rooms, command, proposed, options, PP_STATE_BOTH, line);
}

void pp_rooms_clear(struct pp_rooms *rooms)
{
    for (int i = 0; i < rooms->count; i++)
        pp_study_room_clear(&rooms->list[i]);
    for (int i = 0; i < rooms->building_count; i++)
        pp_building_destroy(rooms->buildings[i]);
    for (int i = 0; i < rooms->doubt_count; i++)
        pp_mistakes_destroy(rooms->doubts[i]);
    free(rooms->doubts);
    free(rooms->buildings);
    free(rooms->list);
    *rooms = (struct pp_rooms){0};
}
