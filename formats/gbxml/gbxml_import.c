/* gbxml_import.c - reads the model, makes and writes rooms, and parses the output until
 * it is valid. */
#include "formats/gbxml/gbxml_import.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "formats/gbxml/gbxml_openings.h"
#include "formats/gbxml/gbxml_read.h"
#include "formats/gbxml/gbxml_trim.h"
#include "formats/gbxml/gbxml_write.h"
#include "model/room/building.h"

/* Maximum number of rooms of a building, and of attempts to write a valid room file. */
enum { ROOMS_MOST = 200, TURNS_MOST = 50 };

struct gbxml_work {
    struct pp_gbxml_model model;
    struct pp_gbxml_room **rooms; /* one per space; NULL: the space has no room */
    struct pp_clipper *clipper;
    struct pp_mistakes *notes;
    const char *file;
    char *xml;
    size_t length;
};

bool pp_gbxml_import_is_xml(const char *bytes, size_t length)
{
    static const struct {
        const char *mark;
        size_t length;
    } wide[] = {{"\xff\xfe<", 3}, {"\xfe\xff\0<", 4}};
    for (int i = 0; i < 2; i++)
        if (length >= wide[i].length
            && memcmp(bytes, wide[i].mark, wide[i].length) == 0)
            return true;
    size_t at = length >= 3 && memcmp(bytes, "\xef\xbb\xbf", 3) == 0 ? 3 : 0;
    while (at < length && strchr(" \t\r\n", bytes[at]) && bytes[at])
        at++;
    return at < length && bytes[at] == '<';
}

/* ---- rooms ---- */

static void drop_room(struct gbxml_work *work, int space)
{
    if (work->rooms[space])
        pp_gbxml_room_clear(work->rooms[space]);
    free(work->rooms[space]);
    work->rooms[space] = NULL;
}

/* Number of the space's openings to the outside. */
static int count_openings(const struct gbxml_work *work,
                          const struct pp_gbxml_space *space)
{
    int count = 0;
    for (int i = 0; i < work->model.surface_count; i++)
        if (pp_gbxml_model_bounds(&work->model.surfaces[i], space)
            && pp_gbxml_model_is_outer(&work->model.surfaces[i]))
            count += work->model.surfaces[i].opening_count;
    return count;
}

/* Removes the openings and rooms that are marked as left out. */
static void take_away(struct gbxml_work *work)
{
    for (int i = 0; i < work->model.space_count; i++) {
        struct pp_gbxml_room *room = work->rooms[i];
        int kept = 0;
        for (int k = 0; room && k < room->opening_count; k++)
            if (room->openings[k].opening->left_out)
                free(room->openings[k].corners);
            else
                room->openings[kept++] = room->openings[k];
        if (room)
            room->opening_count = kept;
        if (work->model.spaces[i].left_out)
            drop_room(work, i);
    }
}

/* Begins the room of a space; it stays NULL, with a note, if the space has no closed
 * envelope. */
static enum pp_status begin_room(struct gbxml_work *work, int index,
                                 struct pp_error *err)
{
    struct pp_gbxml_space *space = &work->model.spaces[index];
    const char *why;
    work->rooms[index] = calloc(1, sizeof *work->rooms[index]);
    if (!work->rooms[index])
        return pp_fail_memory(err);
    enum pp_status status = pp_gbxml_room_begin(work->rooms[index], &why, &work->model,
                                                space, work->clipper, work->notes, err);
    if (status == PP_OK && why) {
        pp_mistakes_add(work->notes, space->line,
                        "space \"%.60s\" %s, so it is not a room. Its openings (%d) "
                        "are ignored, and its external faces are kept as surfaces",
                        space->id, why, count_openings(work, space));
        drop_room(work, index);
    }
    return status;
}

/* The spaces that have a room, and these rooms. */
struct gbxml_placed {
    struct pp_gbxml_room **rooms;
    struct pp_gbxml_space **spaces;
    int count;
};

static enum pp_status list_rooms(struct gbxml_placed *placed,
                                 const struct gbxml_work *work, struct pp_error *err)
{
    const size_t most = (size_t)work->model.space_count + 1;
    *placed = (struct gbxml_placed){calloc(most, sizeof *placed->rooms),
                                    calloc(most, sizeof *placed->spaces), 0};
    if (!placed->rooms || !placed->spaces)
        return pp_fail_memory(err);
    for (int i = 0; i < work->model.space_count; i++)
        if (work->rooms[i]) {
            placed->rooms[placed->count] = work->rooms[i];
            placed->spaces[placed->count++] = &work->model.spaces[i];
        }
    return PP_OK;
}

/* Trims and finishes the rooms, adds their openings, and leaves out rooms that still
 * overlap. */
static enum pp_status finish_rooms(struct gbxml_work *work, struct pp_error *err)
{
    struct gbxml_placed placed;
    enum pp_status status = list_rooms(&placed, work, err);
    if (status == PP_OK)
        pp_gbxml_trim_rooms(placed.rooms, placed.spaces, placed.count, work->notes);
    for (int i = 0; i < placed.count && status == PP_OK; i++) {
        status = pp_gbxml_room_finish(placed.rooms[i], &work->model, placed.spaces[i],
                                      work->notes, err);
        if (status == PP_OK)
            status =
                pp_gbxml_openings_add(placed.rooms[i], &work->model, placed.spaces[i],
                                      work->clipper, work->notes, err);
    }
    if (status == PP_OK)
        status = pp_gbxml_trim_leave_out(placed.rooms, placed.spaces, placed.count,
                                         work->notes, err);
    free(placed.rooms);
    free(placed.spaces);
    return status;
}

static enum pp_status make_rooms(struct gbxml_work *work, struct pp_error *err)
{
    int made = 0, blind = 0, many = 0;
    enum pp_status status = PP_OK;
    work->rooms = calloc((size_t)work->model.space_count + 1, sizeof *work->rooms);
    if (!work->rooms)
        return pp_fail_memory(err);
    for (int i = 0; i < work->model.space_count && status == PP_OK; i++) {
        if (count_openings(work, &work->model.spaces[i]) == 0) {
            blind++;
        } else if (made == ROOMS_MOST) {
            many++;
        } else {
            status = begin_room(work, i, err);
            made += work->rooms[i] != NULL;
        }
    }
    if (status == PP_OK)
        status = finish_rooms(work, err);
    if (status == PP_OK)
        take_away(work);
    if (blind > 0)
        pp_mistakes_add(work->notes, 0,
                        "%d of %d spaces have no window, skylight or glazed door to "
                        "the outside; their external faces are kept as surfaces",
                        blind, work->model.space_count);
    if (many > 0)
        pp_mistakes_add(work->notes, 0,
                        "%d spaces exceed the limit of %d rooms in a building; their "
                        "external faces are kept as surfaces",
                        many, ROOMS_MOST);
    return status;
}

/* Notes defaults for values that gbXML, or this file, lacks. */
static void note_defaults(const struct gbxml_work *work)
{
    int bare = 0;
    for (int i = 0; i < work->model.surface_count; i++)
        bare += isnan(work->model.surfaces[i].reflectance)
                && strcmp(work->model.surfaces[i].type, "Shade") != 0;
    if (bare > 0)
        pp_mistakes_add(
            work->notes, 0,
            "%d of %d surfaces have no visible reflectance inside (IntVisible of their "
            "construction); assumed: floors 0.2, walls 0.5, ceilings 0.7",
            bare, work->model.surface_count);
    pp_mistakes_add(
        work->notes, 0,
        "gbXML files do not contain frames, dirt, reveals, ground reflectance or "
        "ground level; assumed: frame-factor 1, maintenance 1, reveal 0, "
        "reflectance 0.2, level 0");
}

/* ---- validating the output ---- */

static enum pp_status write_all(struct gbxml_work *work,
                                struct pp_gbxml_writing *writing, struct pp_error *err)
{
    free(work->xml);
    work->xml = NULL;
    writing->out = open_memstream(&work->xml, &work->length);
    if (!writing->out)
        return pp_fail_memory(err);
    enum pp_status status = pp_gbxml_write(writing, &work->model, work->rooms, err);
    bool failed = ferror(writing->out) != 0;
    failed |= fclose(writing->out) != 0;
    return status == PP_OK && failed ? pp_fail_memory(err) : status;
}

/* Parses the output as a room file and builds the world of each room. */
static enum pp_status read_back(const struct gbxml_work *work,
                                struct pp_mistakes *mistakes, struct pp_error *err)
{
    struct pp_building *building = NULL;
    struct pp_error fault = {0};
    enum pp_status status =
        pp_building_parse(&building, work->xml, work->length, mistakes, &fault);
    int count = building ? pp_building_room_count(building) : 0;
    for (int i = 0; i < count && status != PP_SYSTEM; i++) {
        struct pp_world *world = NULL;
        enum pp_status made =
            pp_world_create(&world, pp_building_room(building, i), mistakes, &fault);
        status = made == PP_OK ? status : made;
        pp_world_destroy(world);
    }
    pp_building_destroy(building);
    return status == PP_SYSTEM ? pp_fail(err, status, "%s", fault.message) : PP_OK;
}

/* The innermost written item on that line; NULL: none. */
static const struct pp_gbxml_written *find_item(const struct pp_gbxml_writing *writing,
                                                int line)
{
    const struct pp_gbxml_written *found = NULL;
    for (int i = 0; i < writing->item_count; i++) {
        const struct pp_gbxml_written *item = &writing->items[i];
        if (line >= item->first && line <= item->last
            && (!found || item->last - item->first < found->last - found->first))
            found = item;
    }
    return found;
}

/* Marks the causes of the mistakes as left out, openings and surfaces before whole
 * rooms. Returns false if nothing is left to remove. */
static bool leave_out(struct gbxml_work *work, const struct pp_gbxml_writing *writing,
                      const struct pp_mistakes *mistakes)
{
    bool some = false;
    for (int rooms = 0; rooms < 2 && !some; rooms++)
        for (int i = 0; i < mistakes->count; i++) {
            const struct pp_gbxml_written *item =
                find_item(writing, mistakes->list[i].line);
            if (!item || *item->left_out
                || (strcmp(item->what, "space") == 0) != (rooms == 1))
                continue;
            *item->left_out = some = true;
            pp_mistakes_add(work->notes, item->from, "%s \"%.60s\" is ignored: %s",
                            item->what, item->id ? item->id : "",
                            mistakes->list[i].text);
        }
    return some;
}

static bool has_rooms(const struct gbxml_work *work)
{
    for (int i = 0; i < work->model.space_count; i++)
        if (work->rooms[i])
            return true;
    return false;
}

static enum pp_status write_until_good(struct gbxml_work *work, struct pp_error *err)
{
    struct pp_gbxml_writing writing = {0};
    enum pp_status status = PP_OK;
    for (int turn = 0; status == PP_OK; turn++) {
        struct pp_mistakes mistakes;
        if (!has_rooms(work) || turn == TURNS_MOST) {
            status = pp_fail(err, PP_BAD_INPUT,
                             "%s: no space could be converted to a room with an "
                             "opening to the outside",
                             work->file);
            break;
        }
        status = write_all(work, &writing, err);
        pp_mistakes_init(&mistakes, work->file);
        if (status == PP_OK)
            status = read_back(work, &mistakes, err);
        bool good = mistakes.count == 0;
        if (status == PP_OK && !good && !leave_out(work, &writing, &mistakes))
            status = pp_fail(err, PP_BAD_INPUT,
                             "%s: the result is not a valid room file: %s", work->file,
                             mistakes.list[0].text);
        pp_mistakes_clear(&mistakes);
        if (good)
            break;
        take_away(work);
    }
    free(writing.items);
    return status;
}

enum pp_status pp_gbxml_import(char **xml, size_t *length, const char *bytes,
                               size_t byte_count, const char *file,
                               struct pp_mistakes *notes, struct pp_error *err)
{
    struct gbxml_work work = {.notes = notes, .file = file};
    struct pp_xml document;
    *xml = NULL;
    enum pp_status status =
        pp_gbxml_document_parse(&document, bytes, byte_count, file, err);
    if (status == PP_OK)
        status = pp_gbxml_read(&work.model, &document, file, notes, err);
    if (status == PP_OK)
        status = pp_clipper_create(&work.clipper, err);
    if (status == PP_OK)
        status = make_rooms(&work, err);
    if (status == PP_OK)
        status = write_until_good(&work, err);
    if (status == PP_OK) {
        note_defaults(&work);
        pp_mistakes_sort(notes);
        *xml = work.xml;
        *length = work.length;
        work.xml = NULL;
    }
    for (int i = 0; work.rooms && i < work.model.space_count; i++)
        drop_room(&work, i);
    free(work.rooms);
    pp_clipper_destroy(work.clipper);
    free(work.xml);
    pp_gbxml_model_clear(&work.model);
    pp_xml_clear(&document);
    return status;
}
