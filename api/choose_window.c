/* choose_window.c - see choose_window.h. */
#include "api/choose_window.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static bool opening_is_upright(const struct pp_opening *opening)
{
    return fabs(opening->inner.normal.z) < sin(1.0 * PP_RAD);
}

static const char *wall_of(const struct pp_world *world, int opening)
{
    return world->surfaces[world->openings[opening].face].name;
}

/* Index of the window of this name; -1: none. */
static int window_by_name(const struct pp_world *world, const char *words)
{
    for (int i = 0; i < world->opening_count; i++)
        if (world->openings[i].name && strcmp(world->openings[i].name, words) == 0)
            return i;
    return -1;
}

/* Index of the window whose opening is on this line of the room file; -1: none. */
static int window_by_line(const struct pp_world *world, const char *words)
{
    char *end;
    long line = strtol(words, &end, 10);
    for (int i = 0; *end == 0 && i < world->opening_count; i++)
        if (world->openings[i].line == line)
            return i;
    return -1;
}

/* Index of the window in this wall, if it is the wall's only opening; -1: none or
 * several. */
static int window_by_wall(const struct pp_world *world, const char *words)
{
    int found = -1, count = 0;
    for (int i = 0; i < world->opening_count; i++)
        if (wall_of(world, i) && strcmp(wall_of(world, i), words) == 0) {
            found = i;
            count++;
        }
    return count == 1 ? found : -1;
}

enum pp_status pp_choose_window(int *window, const struct pp_world *world,
                                const char *words, bool upright, struct pp_error *err)
{
    *window = 0;
    if (words) {
        *window = window_by_name(world, words);
        if (*window < 0)
            *window = window_by_wall(world, words);
        if (*window < 0)
            *window = window_by_line(world, words);
        if (*window < 0)
            return pp_fail(
                err, PP_BAD_INPUT,
                "--window is \"%.60s\"; expected the name of a window, the name of a "
                "wall with one window, or the line number of a window in the room file",
                words);
    } else {
        while (upright && *window < world->opening_count
               && !opening_is_upright(&world->openings[*window]))
            ++*window;
    }
    if (*window == world->opening_count && !upright)
        return pp_fail(err, PP_BAD_INPUT, "the room has no opening");
    if (*window == world->opening_count)
        return pp_fail(err, PP_BAD_INPUT,
                       "the vertical sky component needs a vertical window, but the "
                       "room has none");
    if (upright && !opening_is_upright(&world->openings[*window]))
        return pp_fail(err, PP_BAD_INPUT,
                       "%s is not vertical, but the vertical sky component is for "
                       "vertical windows only",
                       world->openings[*window].label);
    return PP_OK;
}
