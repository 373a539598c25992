/* building.c - see building.h. */
#include "model/room/building.h"

#include <stdlib.h>
#include <string.h>

#include "model/base/read_file.h"
#include "model/room/build/building_site.h"
#include "model/room/read/read_elements.h"
#include "model/room/read/xml.h"
#include "model/room/room_parts.h"

enum pp_status pp_building_parse(struct pp_building **building, const char *bytes,
                                 size_t length, struct pp_mistakes *mistakes,
                                 struct pp_error *err)
{
    int before = mistakes->count;
    *building = NULL;
    struct pp_building *made = calloc(1, sizeof *made);
    if (made)
        made->text = malloc(length + 1);
    if (!made || !made->text) {
        free(made);
        return pp_fail_memory(err);
    }
    memcpy(made->text, bytes, length);
    made->text[length] = '\0';
    made->text_length = length;

    struct pp_xml xml;
    enum pp_status status = pp_xml_parse(&xml, bytes, length, mistakes, err);
    if (status == PP_OK)
        status = pp_read_elements(made, &xml, mistakes, err);
    if (status == PP_OK)
        status = pp_building_site_settle(made, PP_STATE_PROPOSED, err);
    bool whole = status == PP_OK && xml.whole && made->read_count > 0;
    pp_xml_clear(&xml);
    pp_mistakes_sort(mistakes);

    /* No room of a file that breaks off can be judged: its missing parts may have
     * followed. */
    if (whole)
        *building = made;
    else
        pp_building_destroy(made);
    if (status != PP_OK)
        return status;
    int count = mistakes->count - before;
    if (count > 0 || mistakes->truncated)
        return pp_fail(err, PP_BAD_INPUT, "%s: %d mistake%s%s",
                       mistakes->file ? mistakes->file : "room file", count,
                       count == 1 ? "" : "s", mistakes->truncated ? " or more" : "");
    return PP_OK;
}

enum pp_status pp_building_read(struct pp_building **building, const char *path,
                                struct pp_mistakes *mistakes, struct pp_error *err)
{
    char *bytes;
    size_t length;
    *building = NULL;
    enum pp_status status = pp_read_file(&bytes, &length, path, PP_XML_BYTES_MOST, err);
    if (status == PP_OK)
        status = pp_building_parse(building, bytes, length, mistakes, err);
    free(bytes);
    return status;
}

void pp_building_destroy(struct pp_building *building)
{
    if (!building)
        return;
    pp_building_site_clear(building);
    for (int i = 0; i < building->read_count; i++)
        pp_room_parts_clear(&building->read[i]);
    free(building->read);
    pp_room_parts_clear(&building->common);
    free(building->name);
    free(building->text);
    free(building);
}

const char *pp_building_name(const struct pp_building *building)
{
    return building->name;
}

const char *pp_building_text(const struct pp_building *building, size_t *length)
{
    *length = building->text_length;
    return building->text;
}

int pp_building_room_count(const struct pp_building *building)
{
    return building->room_count;
}

struct pp_room *pp_building_room(struct pp_building *building, int index)
{
    return &building->rooms[index];
}

int pp_building_place(const struct pp_building *building, int index)
{
    return building->places[index];
}

int pp_building_openings_before(const struct pp_building *building, int index)
{
    int count = 0;
    for (int i = 0; i < building->places[index]; i++)
        count += building->openings[i];
    return count;
}

bool pp_building_has_states(const struct pp_building *building)
{
    return building->has_states;
}

enum pp_status pp_building_set_state(struct pp_building *building,
                                     enum pp_site_state state, struct pp_error *err)
{
    return pp_building_site_settle(building, state, err);
}
