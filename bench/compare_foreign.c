/* compare_foreign.c - makes rooms with mistakes, by changes to the text of a room
 * file. */
#include "bench/compare_foreign.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "model/room/position.h"
#include "model/room/room.h"
#include "model/room/room_light.h"

enum { TEXT_BYTES = 1 << 20, WORD_BYTES = 64 };

/* Changes v to v (1 + s share) + s amount; |s| is random between 0.5 and 1, and s is
 * positive if grows is set. */
struct mistake {
    const char *name, *element, *attribute;
    double share, amount;
    bool grows;
};

static const struct mistake mistakes[] = {
    {"walls", "<finishes", " walls=\"", 0.0, 0.2, false},
    {"walls", "<finishes", " walls=\"", 0.0, 0.2, false},
    {"floor", "<finishes", " floor=\"", 0.0, 0.2, false},
    {"ceiling", "<finishes", " ceiling=\"", 0.0, 0.2, false},
    {"depth", "<plan", " depth=\"", 0.1, 0.0, true},
    {"room width", "<plan", " width=\"", 0.1, 0.0, true},
    {"room height", "<plan", " height=\"", 0.1, 0.0, true},
    {"sill", "<window", " sill=\"", 0.0, 0.2, false},
    {"window width", "<window", " width=\"", 0.1, 0.0, false},
    {"window height", "<window", " height=\"", 0.1, 0.0, false},
    {"block height", "<block", " height=\"", 0.3, 0.0, false},
    {"skyline", "<skyline", " angle=\"", 0.3, 0.0, false},
    {"sky", NULL, NULL, 0.0, 0.0, false},
    {"points", NULL, NULL, 0.0, 0.3, false},
};
enum { COUNT = sizeof mistakes / sizeof mistakes[0] };

char *pp_foreign_text_of(const char *path)
{
    FILE *file = fopen(path, "r");
    char *text = calloc(1, TEXT_BYTES);
    size_t size = file && text ? fread(text, 1, TEXT_BYTES - 1, file) : 0;
    if (file)
        fclose(file);
    if (size > 0)
        return text;
    free(text);
    return NULL;
}

bool pp_foreign_room(struct pp_building **building, struct pp_study_room *study,
                     const char *path, const char *text)
{
    struct pp_mistakes found;
    struct pp_world *world = NULL;
    struct pp_outside_light light;
    *building = NULL;
    pp_mistakes_init(&found, path);
    enum pp_status status =
        pp_building_parse(building, text, strlen(text), &found, NULL);
    const struct pp_room *room =
        status == PP_OK ? pp_building_room(*building, 0) : NULL;
    if (status == PP_OK)
        status = pp_world_create(&world, room, &found, NULL);
    if (status == PP_OK)
        status = pp_room_light(&light, room, NULL);
    pp_mistakes_clear(&found);
    if (status == PP_OK) {
        pp_study_room_init(study, path, *building, 0, room, world, &light);
        return true;
    }
    pp_world_destroy(world);
    pp_building_destroy(*building);
    return false;
}

/* Changes the attribute of all elements of that name. False if there is no such
 * attribute, or if its value is not a number. */
static bool change(char *to, const char *text, const struct mistake *mistake,
                   double size)
{
    bool changed = false;
    *to = '\0';
    for (const char *at; (at = strstr(text, mistake->element)) != NULL;) {
        const char *end = at + strcspn(at, ">");
        const char *value = strstr(at, mistake->attribute);
        if (value && value < end) {
            value += strlen(mistake->attribute);
            char *behind;
            double is = strtod(value, &behind);
            if (*behind != '"')
                return false; /* a named finish */
            sprintf(to + strlen(to), "%.*s%.9g", (int)(value - text), text,
                    is * (1.0 + mistake->share * size) + mistake->amount * size);
            text = value + strcspn(value, "\"");
            changed = true;
        }
        strncat(to, text, (size_t)(end - text));
        text = end;
    }
    strcat(to, text);
    return changed;
}

/* Adds a sky that is not among the listed causes. */
static bool change_sky(char *to, const char *text)
{
    const char *at = strstr(text, "<plan");
    if (!at || strstr(text, "<sky"))
        return false;
    sprintf(to, "%.*s<sky type=\"iso-3\"/>%s", (int)(at - text), text, at);
    return true;
}

/* Moves the points by back_m (m) towards the back of the room. False if a point would
 * no longer be valid. */
static bool place_points(struct pp_study_room *study, const struct pp_receiver *points,
                         int count, double back_m)
{
    struct pp_receiver *own = malloc(((size_t)count + 1) * sizeof *own);
    if (!own)
        return false;
    for (int i = 0; i < count; i++) {
        own[i] = points[i];
        own[i].position.y += back_m;
    }
    pp_study_room_set_points(study, own, count);
    for (int i = 0; i < count; i++)
        if (pp_position_receiver_fault(study->world, own[i].position, own[i].normal))
            return false;
    return true;
}

const char *pp_foreign_draw(struct pp_building **building, struct pp_study_room *study,
                            const char *path, const char *text,
                            const struct pp_receiver *points, int count, double u1,
                            double u2)
{
    const struct mistake *mistake = &mistakes[(int)(COUNT * u1)];
    double size = mistake->grows ? 0.5 + 0.5 * u2 : u2 < 0.5 ? u2 - 1.0 : u2;
    char *to = calloc(1, 2 * TEXT_BYTES);
    if (!to)
        return NULL;
    bool good = mistake->element                    ? change(to, text, mistake, size)
                : strcmp(mistake->name, "sky") == 0 ? change_sky(to, text)
                                                    : strcpy(to, text) != NULL;
    good = good && pp_foreign_room(building, study, path, to);
    free(to);
    if (!good)
        return NULL;
    double back_m = mistake->element ? 0.0 : mistake->amount * size;
    if (place_points(study, points, count, back_m))
        return mistake->name;
    pp_study_room_clear(study);
    pp_building_destroy(*building);
    return NULL;
}
