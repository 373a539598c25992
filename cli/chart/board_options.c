/* board_options.c - reads and checks the options of drawing-board charts: glazing,
 * slope, sky and receiver. */
#include "cli/chart/board_options.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "model/base/text.h"
#include "model/light/glazings.h"
#include "model/room/sky_words.h"

static enum pp_status read_either(const char *text, const char *yes, const char *no,
                                  void *place, struct pp_error *err)
{
    if (strcmp(text, yes) != 0 && strcmp(text, no) != 0)
        return pp_fail(err, PP_BAD_INPUT, "%s or %s", yes, no);
    *(enum pp_yes_no *)place = strcmp(text, yes) == 0 ? PP_YES : PP_NO;
    return PP_OK;
}

enum pp_status pp_board_options_read_yes_no(const char *text, void *place,
                                            struct pp_error *err)
{
    return read_either(text, "yes", "no", place, err);
}

enum pp_status pp_board_options_read_receiver(const char *text, void *place,
                                              struct pp_error *err)
{
    return read_either(text, "vertical", "horizontal", place, err);
}

enum pp_status pp_board_options_read_viewing_mm(const char *text, void *place,
                                                struct pp_error *err)
{
    double mm;
    if (!pp_text_parse_number(text, &mm) || !(mm >= 5.0 && mm <= 200.0))
        return pp_fail(err, PP_BAD_INPUT, "a number of millimetres from 5 to 200");
    *(double *)place = mm;
    return PP_OK;
}

enum pp_status pp_board_options_read_protractor(const char *text, void *place,
                                                struct pp_error *err)
{
    double number;
    if (!pp_text_parse_number(text, &number) || number != floor(number) || number < 1.0
        || number > 10.0)
        return pp_fail(err, PP_BAD_INPUT, "a whole number from 1 to 10");
    *(int *)place = (int)number;
    return PP_OK;
}

/* Reads numbers separated by commas. Returns how many there are, or -1 if the text is
 * invalid. */
static int read_list(const char *text, double *numbers, int most)
{
    char copy[160];
    int count = 0;
    if (strlen(text) >= sizeof copy)
        return -1;
    snprintf(copy, sizeof copy, "%s", text);
    char *rest = copy, *part;
    while ((part = strsep(&rest, ",")) != NULL) {
        if (count == most || !pp_text_parse_number(part, &numbers[count]))
            return -1;
        count++;
    }
    return count;
}

enum pp_status pp_board_options_read_slats(const char *text, void *place,
                                           struct pp_error *err)
{
    struct pp_board_options *board = place;
    double n[6];
    int count = read_list(text, n, 6);
    if (count < 3 || !(n[0] >= 0.001 && n[0] <= 10.0 && n[1] >= 0.001 && n[1] <= 10.0)
        || !(fabs(n[2]) <= 90.0) || (count > 3 && !(n[3] >= 0.0 && n[3] <= 1.0))
        || (count > 4 && !(n[4] >= 0.0 && n[4] <= 1.0))
        || (count > 5 && !(fabs(n[5]) <= 0.5 * n[0])))
        return pp_fail(err, PP_BAD_INPUT,
                       "width and spacing in m (0.001 to 10), angle in degrees (-90 to "
                       "90), then reflectance above and below (0 to 1) and curvature "
                       "in m, such as 0.025,0.02,-45,0.6");
    double upper = count > 3 ? n[3] : 0.5;
    board->slats = (struct pp_slats){.width = n[0],
                                     .spacing = n[1],
                                     .tilt_rad = n[2] * PP_RAD,
                                     .upper = upper,
                                     .lower = count > 4 ? n[4] : upper,
                                     .rise = count > 5 ? n[5] : 0.0};
    board->slats_said = true;
    return PP_OK;
}

enum pp_status pp_board_options_read_slope(const char *text, void *place,
                                           struct pp_error *err)
{
    struct pp_board_options *board = place;
    double slope;
    if (!pp_text_parse_number(text, &slope) || !(slope >= 0.0 && slope <= 90.0))
        return pp_fail(err, PP_BAD_INPUT,
                       "a number of degrees from 0 (horizontal) to 90 (vertical)");
    board->slope_deg = slope;
    board->slope_said = true;
    return PP_OK;
}

enum pp_status pp_board_options_read_inclined(const char *text, void *place,
                                              struct pp_error *err)
{
    struct pp_board_options *board = place;
    double degrees;
    if (!pp_text_parse_number(text, &degrees) || !(degrees >= -90.0 && degrees <= 90.0))
        return pp_fail(err, PP_BAD_INPUT,
                       "a number of degrees from -90 (edge nearest on the left) "
                       "to 90");
    board->inclined_deg = degrees;
    board->inclined = true;
    return PP_OK;
}

enum pp_status pp_board_options_read_nomogram(const char *text, void *place,
                                              struct pp_error *err)
{
    static const char *const names[PP_NOMOGRAM_POSITION] = {
        [PP_NOMOGRAM_AVERAGE] = "average",
        [PP_NOMOGRAM_MINIMUM] = "minimum",
        [PP_NOMOGRAM_ROOFLIGHT] = "rooflight",
    };
    struct pp_board_options *board = place;
    for (int i = 0; i < PP_NOMOGRAM_POSITION; i++)
        if (strcmp(text, names[i]) == 0) {
            board->nomogram = (enum pp_nomogram_kind)i;
            board->nomogram_said = true;
            return PP_OK;
        }
    return pp_fail(err, PP_BAD_INPUT, "average, minimum or rooflight");
}

/* Sets the sky of a blank diagram from the value of --sky. */
static enum pp_status set_sky(struct pp_board_options *board, const char *words,
                              struct pp_error *err)
{
    board->sky = pp_sky_overcast();
    if (!words)
        return PP_OK;
    struct pp_sky_part part = pp_sky_words_default();
    struct pp_error why = {0};
    if (pp_sky_words_parse(&part, words, &why) != PP_OK)
        return pp_fail(err, PP_BAD_INPUT, "--sky: %s", why.message);
    board->picture = part.picture;
    return pp_sky_words_sky(&board->sky, &part, 0.0, err);
}

/* Sets slope and glass. If glazing, slope or sky is given, also selects a protractor
 * for them. */
static enum pp_status set_protractor(struct pp_board_options *board,
                                     const char *sky_words, struct pp_error *err)
{
    const char *name = board->glazing ? board->glazing : "clear-single";
    bool other = board->glazing || board->slope_said || sky_words;
    if (board->number && other)
        return pp_fail(err, PP_BAD_INPUT,
                       "--number selects a protractor with its glazing, slope and sky; "
                       "expected --number, or --glazing, --slope and --sky");
    board->any_protractor = !board->number && other;
    board->slope_rad = (board->slope_said ? board->slope_deg : 90.0) * PP_RAD;
    const struct pp_glazing *glazing = pp_glazings_find(name);
    if (!glazing && strcmp(name, "none") != 0)
        return pp_fail(err, PP_BAD_INPUT,
                       "--glazing is \"%.60s\"; expected a name from the table of "
                       "glazings, such as clear-double, or none",
                       name);
    board->glass = glazing ? pp_glazings_glass(glazing) : pp_glass_none();
    if (board->glass.diffusing)
        return pp_fail(
            err, PP_BAD_INPUT,
            "--glazing %s is diffusing; expected clear glass for a protractor", name);
    if (pp_sky_has_azimuth(&board->sky))
        return pp_fail(err, PP_BAD_INPUT,
                       "--sky is \"%.60s\"; expected a sky whose luminance does not "
                       "depend on azimuth",
                       sky_words);
    if (strcmp(name, "clear-single") == 0)
        snprintf(board->glass_words, sizeof board->glass_words, "clear single glass");
    else
        snprintf(board->glass_words, sizeof board->glass_words, "glazing %.40s", name);
    return PP_OK;
}

enum pp_status pp_board_options_check(struct pp_board_options *board,
                                      const struct pp_room_options *options,
                                      const struct pp_chart_kind *kind, bool blank,
                                      struct pp_error *err)
{
    bool pepper_pot = strcmp(kind->name, "pepper-pot") == 0;
    bool protractor = strcmp(kind->name, "protractor") == 0;
    bool waldram =
        strcmp(kind->name, "waldram") == 0 || strcmp(kind->name, "vertical-sky") == 0;
    bool overlay = strcmp(kind->name, "overlay") == 0;
    bool slats = strcmp(kind->name, "slats") == 0;
    bool nomogram = strcmp(kind->name, "nomogram") == 0;
    bool position = strcmp(kind->name, "position-nomogram") == 0;
    const char *needless =
        options->study.simulate  ? "--simulate"
        : options->study.methods ? "--methods"
        : (blank || nomogram || kind->of_window) && options->study.points.count
            ? "--points"
        : blank && options->room                 ? "--room"
        : !pepper_pot && board->fine             ? "--fine"
        : !pepper_pot && board->vertical         ? "--receiver"
        : !pepper_pot && board->viewing_mm > 0.0 ? "--viewing-distance"
        : (protractor || nomogram || position || kind->of_window) && board->glazed
            ? "--glazed"
        : (blank || position || !kind->from_point) && board->unsolved ? "--unsolved"
        : (blank || !kind->of_window) && board->window                ? "--window"
        : !blank && kind->of_window && options->study.sky             ? "--sky"
        : !nomogram && board->nomogram_said                           ? "--which"
        : !protractor && board->number                                ? "--number"
        : !protractor && board->glazing                               ? "--glazing"
        : !protractor && board->slope_said                            ? "--slope"
        : !slats && board->slats_said                                 ? "--slats"
        : slats && options->study.sky                                 ? "--sky"
        : !overlay && board->overlay.typed ? board->overlay.typed
        : !waldram && board->inclined      ? "--inclined"
        : overlay && board->glazed         ? "--glazed"
                                           : NULL;
    if (needless)
        return pp_fail(err, PP_BAD_INPUT, "%s does not apply to a %s%s diagram",
                       needless, blank ? "blank " : "", kind->name);
    if (!blank && (board->number || board->glazing || board->slope_said))
        return pp_fail(
            err, PP_BAD_INPUT,
            "%s is for a blank protractor; for a room, it is taken from the room file",
            board->number    ? "--number"
            : board->glazing ? "--glazing"
                             : "--slope");
    if (!blank && (board->glazed || board->vertical))
        return pp_fail(
            err, PP_BAD_INPUT,
            "%s is for a blank diagram; for a room, it is taken from the room file",
            board->glazed ? "--glazed" : "--receiver");
    if (slats && blank != board->slats_said)
        return pp_fail(err, PP_BAD_INPUT,
                       blank ? "a chart of slats needs a blind; expected --slats "
                               "WIDTH,SPACING,ANGLE, or a room file"
                             : "--slats is for a chart without a room; for a room, the "
                               "blind is taken from the room file");
    enum pp_status status = set_sky(board, options->study.sky, err);
    if (status == PP_OK && (nomogram || position) && board->sky.kind != PP_SKY_OVERCAST)
        status = pp_fail(
            err, PP_BAD_INPUT,
            "--sky is \"%.60s\"; expected overcast, the only sky of the nomograms",
            options->study.sky);
    if (status == PP_OK && protractor)
        status = set_protractor(board, options->study.sky, err);
    return status;
}
