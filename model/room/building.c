/* building.c - the room file's door to the world: see building.h. */
#include "model/room/building.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/read_file.h"
#include "model/base/text.h"
#include "model/room/read/read_elements.h"
#include "model/room/read/room_schema.h"
#include "model/room/read/xml.h"

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
    bool whole = status == PP_OK && xml.whole && made->room_count > 0;
    pp_xml_clear(&xml);
    pp_mistakes_sort(mistakes);

    /* Of a file that breaks off, no room can be judged: what it lacks may follow. */
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
    for (int i = 0; i < building->room_count; i++)
        pp_room_clear(&building->rooms[i]);
    free(building->rooms);
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

/* The sun of "TYPE,ALTITUDE,BEARING", behind the first comma. */
static bool read_sun(const char *text, double *altitude_deg, double *bearing_deg)
{
    char copy[128];
    size_t length = strlen(text);
    if (length >= sizeof copy)
        return false;
    memcpy(copy, text, length + 1);
    char *comma = strchr(copy, ',');
    if (!comma)
        return false;
    *comma = '\0';
    return pp_text_parse_number(copy, altitude_deg)
           && pp_text_parse_number(comma + 1, bearing_deg) && *altitude_deg >= 0.0
           && *altitude_deg <= 90.0 && fabs(*bearing_deg) <= 360.0;
}

enum pp_status pp_room_set_sky(struct pp_room *room, const char *spec,
                               struct pp_error *err)
{
    char type[16], shown[64];
    const char *comma = strchr(spec, ',');
    size_t length = comma ? (size_t)(comma - spec) : strlen(spec);
    int index = 0;
    if (length < sizeof type) {
        memcpy(type, spec, length);
        type[length] = '\0';
        while (pp_sky_words[index] && strcmp(pp_sky_words[index], type) != 0)
            index++;
    }
    if (length >= sizeof type || !pp_sky_words[index])
        return pp_fail(err, PP_BAD_INPUT,
                       "there is no sky \"%s\"; expected overcast, uniform or iso-1 to "
                       "iso-15",
                       pp_text_excerpt(shown, sizeof shown, spec));

    struct pp_sky_part sky = room->sky;
    double altitude_deg, bearing_deg;
    if (comma && !read_sun(comma + 1, &altitude_deg, &bearing_deg))
        return pp_fail(err, PP_BAD_INPUT,
                       "the sky \"%s\" has no sun that could stand there; expected "
                       "TYPE,ALTITUDE,BEARING, with 0 to 90 and -360 to 360 degrees",
                       pp_text_excerpt(shown, sizeof shown, spec));
    if (comma) {
        sky.sun_altitude_rad = altitude_deg * PP_RAD;
        sky.sun_bearing_rad = bearing_deg * PP_RAD;
    }
    sky.kind = index == 0 ? PP_SKY_OVERCAST : index == 1 ? PP_SKY_UNIFORM : PP_SKY_ISO;
    sky.iso = index > 1 ? index - 1 : 0;
    if (sky.kind == PP_SKY_ISO && pp_sky_iso_has_sun(sky.iso)
        && (isnan(sky.sun_altitude_rad) || isnan(sky.sun_bearing_rad)))
        return pp_fail(err, PP_BAD_INPUT,
                       "the sky %s needs to know where the sun stands, and the room "
                       "file does not say; expected %s,ALTITUDE,BEARING in degrees",
                       type, type);
    room->sky = sky;
    return PP_OK;
}
