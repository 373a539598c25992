#include "cli/board_options.h"

#include <math.h>
#include <string.h>

#include "model/number.h"
#include "model/room.h"
#include "model/room_parts.h"

static enum pp_status read_either(const char *text, const char *yes, const char *no,
                                  void *place, struct pp_error *err)
{
    if (strcmp(text, yes) != 0 && strcmp(text, no) != 0)
        return pp_fail(err, PP_BAD_INPUT, "%s or %s", yes, no);
    *(enum pp_yes_no *)place = strcmp(text, yes) == 0 ? PP_YES : PP_NO;
    return PP_OK;
}

enum pp_status pp_read_yes_no(const char *text, void *place, struct pp_error *err)
{
    return read_either(text, "yes", "no", place, err);
}

enum pp_status pp_read_receiver(const char *text, void *place, struct pp_error *err)
{
    return read_either(text, "vertical", "horizontal", place, err);
}

enum pp_status pp_read_viewing_distance(const char *text, void *place,
                                        struct pp_error *err)
{
    double mm;
    if (!pp_number_parse(text, &mm) || !(mm >= 5.0 && mm <= 200.0))
        return pp_fail(err, PP_BAD_INPUT, "a number of millimetres from 5 to 200");
    *(double *)place = mm;
    return PP_OK;
}

/* The sky of a blank, by the words of --sky. */
static enum pp_status set_sky(struct pp_sky *sky, const char *words,
                              struct pp_error *err)
{
    *sky = pp_sky_overcast();
    if (!words)
        return PP_OK;
    struct pp_room room = {.sky = {.sun_altitude_rad = NAN, .sun_bearing_rad = NAN}};
    struct pp_error why = {0};
    if (pp_room_set_sky(&room, words, &why) != PP_OK)
        return pp_fail(err, PP_BAD_INPUT, "--sky: %s", why.message);
    if (room.sky.kind == PP_SKY_UNIFORM)
        *sky = pp_sky_uniform();
    if (room.sky.kind != PP_SKY_ISO)
        return PP_OK;
    double altitude =
        isnan(room.sky.sun_altitude_rad) ? PP_PI / 2.0 : room.sky.sun_altitude_rad;
    double bearing = isnan(room.sky.sun_bearing_rad) ? 0.0 : room.sky.sun_bearing_rad;
    struct pp_vec3 sun = {cos(altitude) * sin(bearing), cos(altitude) * cos(bearing),
                          sin(altitude)};
    return pp_sky_iso(sky, room.sky.iso, sun, err);
}

enum pp_status pp_board_options_check(struct pp_board_options *board,
                                      const struct pp_room_options *options,
                                      const struct pp_chart_kind *kind, bool blank,
                                      struct pp_error *err)
{
    bool pepper_pot = strcmp(kind->name, "pepper-pot") == 0;
    const char *needless = options->simulate                ? "--simulate"
                           : options->methods               ? "--methods"
                           : blank && options->points.count ? "--points"
                           : blank && options->room         ? "--room"
                           : !pepper_pot && board->fine     ? "--fine"
                           : !pepper_pot && board->vertical ? "--receiver"
                           : !pepper_pot && board->viewing_mm > 0.0
                               ? "--viewing-distance"
                               : NULL;
    if (needless)
        return pp_fail(err, PP_BAD_INPUT, "%s has no meaning for a %s%s diagram",
                       needless, blank ? "blank " : "", kind->name);
    if (!blank && (board->glazed || board->vertical))
        return pp_fail(err, PP_BAD_INPUT,
                       "%s is for a blank diagram; a room has its own",
                       board->glazed ? "--glazed" : "--receiver");
    return set_sky(&board->sky, options->sky, err);
}
