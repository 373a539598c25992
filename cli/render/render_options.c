/* render_options.c - option tables of the command render, and the readers of their
 * values. */
#include "cli/render/render_options.h"

#include <math.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

#include "model/base/text.h"
#include "model/pictures/raster.h"

/* ---- readers ---- */

static enum pp_status read_coordinates(const char *text, void *place, int least,
                                       const char *expected, struct pp_error *err)
{
    struct pp_coordinates *coordinates = place;
    double v[3] = {0.0, 0.0, NAN};
    int count = pp_options_numbers(text, ',', v, 3);
    for (int i = 0; i < count; i++)
        if (fabs(v[i]) > 1e6)
            count = -1;
    if (count < least)
        return pp_fail(err, PP_BAD_INPUT, "%s", expected);
    *coordinates = (struct pp_coordinates){count, pp_vec(v[0], v[1], v[2])};
    return PP_OK;
}

static enum pp_status read_place(const char *text, void *place, struct pp_error *err)
{
    return read_coordinates(text, place, 2,
                            "a point X,Y or X,Y,Z in metres, such as 1.5,8,1.6", err);
}

static enum pp_status read_direction(const char *text, void *place,
                                     struct pp_error *err)
{
    struct pp_coordinates read;
    enum pp_status status =
        read_coordinates(text, &read, 3, "a direction X,Y,Z, such as 0,-1,0", err);
    if (status != PP_OK)
        return status;
    if (!(pp_vec_length(read.is) > 1e-9))
        return pp_fail(err, PP_BAD_INPUT, "a direction X,Y,Z that is not 0");
    *(struct pp_coordinates *)place = read;
    return PP_OK;
}

/* Index of a word in a list that ends with NULL; -1: none. */
static int which_word(const char *text, const char *const words[])
{
    for (int i = 0; words[i]; i++)
        if (strcmp(text, words[i]) == 0)
            return i;
    return -1;
}

static enum pp_status read_view(const char *text, void *place, struct pp_error *err)
{
    static const char *const words[] = {"perspective",   "parallel", "plan", "section",
                                        "hemispherical", "angular",  NULL};
    int which = which_word(text, words);
    if (which < 0)
        return pp_fail(err, PP_BAD_INPUT,
                       "perspective, parallel, plan, section, hemispherical or "
                       "angular");
    *(enum pp_view_choice *)place = (enum pp_view_choice)which;
    return PP_OK;
}

static enum pp_status read_quantity(const char *text, void *place, struct pp_error *err)
{
    for (int i = 0; i < PP_QUANTITY_COUNT; i++)
        if (strcmp(text, pp_quantity_words((enum pp_quantity)i).name) == 0) {
            *(struct pp_quantity_choice *)place =
                (struct pp_quantity_choice){true, (enum pp_quantity)i};
            return PP_OK;
        }
    return pp_fail(err, PP_BAD_INPUT, "luminance, illuminance or df");
}

static enum pp_status read_filter(const char *text, void *place, struct pp_error *err)
{
    static const char *const words[] = {"box", "gauss", NULL};
    int which = which_word(text, words);
    if (which < 0)
        return pp_fail(err, PP_BAD_INPUT, "box or gauss");
    *(enum pp_pixel_filter *)place = (enum pp_pixel_filter)which;
    return PP_OK;
}

static enum pp_status read_range(const char *text, double low, double high,
                                 double *value, struct pp_error *err)
{
    if (pp_text_parse_number(text, value) && *value > low && *value <= high)
        return PP_OK;
    return pp_fail(err, PP_BAD_INPUT, "a number above %g, up to %g", low, high);
}

static enum pp_status read_angle(const char *text, void *place, struct pp_error *err)
{
    return read_range(text, 0.0, 360.0, place, err);
}

static enum pp_status read_across(const char *text, void *place, struct pp_error *err)
{
    return read_range(text, 0.0, 1e6, place, err);
}

static enum pp_status read_whole(const char *text, int least, int most, int *value,
                                 struct pp_error *err)
{
    double number;
    if (!pp_text_parse_number(text, &number) || number != floor(number)
        || number < least || number > most)
        return pp_fail(err, PP_BAD_INPUT, "a whole number from %d to %d", least, most);
    *value = (int)number;
    return PP_OK;
}

static enum pp_status read_samples(const char *text, void *place, struct pp_error *err)
{
    int count = 0;
    enum pp_status status = read_whole(text, 1, PP_RENDER_SAMPLES_MOST, &count, err);
    if (status == PP_OK && (count & (count - 1)))
        status = pp_fail(err, PP_BAD_INPUT, "a power of two from 1 to %d",
                         PP_RENDER_SAMPLES_MOST);
    *(int *)place = count;
    return status;
}

static enum pp_status read_paper(const char *text, void *place, struct pp_error *err)
{
    struct pp_paper_choice *paper = place;
    paper->said = true;
    return pp_sheet_options_read_paper(text, &paper->is, err);
}

static enum pp_status read_engine(const char *text, void *place, struct pp_error *err)
{
    static const char *const words[] = {"cache", "path", NULL};
    int which = which_word(text, words);
    if (which < 0)
        return pp_fail(err, PP_BAD_INPUT, "cache or path");
    *(bool *)place = which == 1;
    return PP_OK;
}

static enum pp_status read_windows(const char *text, void *place, struct pp_error *err)
{
    static const char *const words[] = {"stored", "aimed", "chance", NULL};
    int which = which_word(text, words);
    if (which < 0)
        return pp_fail(err, PP_BAD_INPUT, "stored, aimed or chance");
    *(enum pp_window_light *)place = (enum pp_window_light)which;
    return PP_OK;
}

static enum pp_status read_size(const char *text, void *place, struct pp_error *err)
{
    double sides[2];
    int count = pp_options_numbers(text, 'x', sides, 2);
    for (int i = 0; i < count; i++)
        if (sides[i] != floor(sides[i]) || sides[i] < 1.0
            || sides[i] > PP_PICTURE_SIDE_MOST)
            count = -1;
    if (count != 2 || sides[0] * sides[1] > PP_PICTURE_PIXELS_MOST)
        return pp_fail(err, PP_BAD_INPUT,
                       "a width and a height in pixels, such as 640x480, each at most "
                       "%d, and at most %d million pixels in all",
                       PP_PICTURE_SIDE_MOST, PP_PICTURE_PIXELS_MOST / 1000000);
    *(struct pp_picture_size *)place =
        (struct pp_picture_size){(int)sides[0], (int)sides[1]};
    return PP_OK;
}

static enum pp_status read_exposure(const char *text, void *place, struct pp_error *err)
{
    struct pp_exposure exposure = {.said = true};
    if (strcmp(text, "auto") == 0)
        exposure.way = PP_TONE_AUTOMATIC;
    else if (strcmp(text, "human") == 0)
        exposure.way = PP_TONE_HUMAN;
    else if (pp_text_parse_number(text, &exposure.white) && exposure.white > 1e-12
             && exposure.white < 1e12)
        exposure.way = PP_TONE_BY_HAND;
    else
        return pp_fail(err, PP_BAD_INPUT,
                       "auto, human, or the value shown as white, such as 2000");
    *(struct pp_exposure *)place = exposure;
    return PP_OK;
}

static enum pp_status read_levels(const char *text, void *place, struct pp_error *err)
{
    struct pp_levels levels = {0};
    levels.count = pp_options_numbers(text, ',', levels.list, PP_LEVELS_MOST);
    bool good = levels.count >= 1 && levels.list[0] > 0.0;
    for (int i = 1; i < levels.count; i++)
        good = good && levels.list[i] > levels.list[i - 1];
    if (!good || levels.list[levels.count - 1] > 1e12)
        return pp_fail(
            err, PP_BAD_INPUT,
            "up to %d increasing levels above 0, separated by commas, such as 1,2,5",
            PP_LEVELS_MOST);
    *(struct pp_levels *)place = levels;
    return PP_OK;
}

static enum pp_status read_ends(const char *text, void *place, struct pp_error *err)
{
    struct pp_levels range = {0};
    if (read_levels(text, &range, NULL) != PP_OK || range.count != 2)
        return pp_fail(err, PP_BAD_INPUT,
                       "LOW,HIGH with 0 < LOW < HIGH, such as 1,500");
    *(struct pp_levels *)place = range;
    return PP_OK;
}

static enum pp_status read_picture_format(const char *text, void *place,
                                          struct pp_error *err)
{
    struct pp_picture_format format;
    char names[128];
    if (!pp_picture_format_named(&format, text))
        return pp_fail(err, PP_BAD_INPUT, "%s",
                       pp_picture_format_list(names, sizeof names, "", false));
    *(const char **)place = text;
    return PP_OK;
}

/* ---- the lists ---- */

#define PLACE(member) offsetof(struct pp_render_choice, member)

const struct pp_option pp_render_view_options[] = {
    {"view", 'v', "KIND",
     "perspective (default), parallel, plan or section (parallel views of the whole "
     "room), hemispherical or angular (fisheyes).",
     read_view, PLACE(view)},
    {"from", 0, "X,Y[,Z]",
     "Position of the eye in metres. Without Z it is 1.6 m above the floor, or for a "
     "fisheye on the working plane. (Default: at the back of the room, facing its "
     "largest window; for a fisheye the middle of the room.)",
     read_place, PLACE(from)},
    {"towards", 0, "X,Y[,Z]",
     "Point at the centre of the view; without Z at the height of the eye.", read_place,
     PLACE(towards)},
    {"direction", 0, "X,Y,Z",
     "Direction of view, instead of --towards (default: towards the largest window; "
     "for a fisheye up).",
     read_direction, PLACE(direction)},
    {"up", 0, "X,Y,Z",
     "Direction that is up in the picture (default 0,0,1; for a view up or down "
     "0,1,0).",
     read_direction, PLACE(up)},
    {"angle", 0, "DEG",
     "Angle of view across the picture (default 75; for fisheyes 180).", read_angle,
     PLACE(angle_deg)},
    {"across", 0, "M", "Width of a parallel view in metres (default: the whole room).",
     read_across, PLACE(across_m)},
    {"size", 0, "WxH",
     "Size of the picture in pixels (default 640x480, for fisheyes 512x512; for plan "
     "and section 640 on the longer side).",
     read_size, PLACE(size)},
    {0},
};

const struct pp_option pp_render_picture_options[] = {
    {"quantity", 0, "NAME",
     "luminance (default) in cd/m²; or, on visible surfaces, illuminance in lux, or "
     "df, the daylight factor in per cent. The .hdr and .pfm files store these divided "
     "by 179, 179 and 100.",
     read_quantity, PLACE(quantity)},
    {"samples", 0, "N",
     "Paths per pixel, a power of two (default 16). Four times as many paths halve the "
     "noise.",
     read_samples, PLACE(samples)},
    {"engine", 0, "NAME",
     "Calculation of reflected light: cache (default) uses an irradiance cache; path "
     "has no bias but more noise.",
     read_engine, PLACE(paths)},
    {"windows", 0, "HOW",
     "Sampling of windows. stored (default): windows are sampled like lamps, with "
     "the light from outside calculated once. aimed: the same, but with the light "
     "from outside calculated for each path, without bias. chance: only scattered "
     "rays reach windows.",
     read_windows, PLACE(windows)},
    {"filter", 0, "NAME", "Filter for pixels: box (default) or gauss, which is softer.",
     read_filter, PLACE(filter)},
    {"checkpoint", 0, "FILE",
     "Save the work in FILE, and continue from FILE if it belongs to the same picture.",
     pp_options_read_updated, PLACE(checkpoint)},
    {"errors", 0, "FILE",
     "Write the standard errors of the pixels to FILE, .hdr or .pfm, in the unit of "
     "the picture. They include the noise of independent paths from --samples (4 or "
     "more, in up to 32 groups), but not the error of the irradiance cache.",
     pp_options_read_output, PLACE(errors)},
    {0},
};

const struct pp_option pp_render_shown_options[] = {
    {"exposure", 0, "HOW",
     "Exposure of a PNG: auto (default), human (contrast as seen by an eye in the "
     "room), or the value that is shown as white.",
     read_exposure, PLACE(exposure)},
    {"false-colour", 0, NULL,
     "PNG, PDF, SVG: draw a sheet with the values as colours, a scale and contours.",
     NULL, PLACE(false_colour)},
    {"range", 0, "LOW,HIGH",
     "Ends of the scale, in the unit of the quantity (default: range of the picture).",
     read_ends, PLACE(range)},
    {"linear", 0, NULL, "Linear scale instead of a logarithmic one.", NULL,
     PLACE(linear)},
    {"levels", 0, "LIST",
     "Values of the contours, separated by commas (default: round values of the "
     "scale).",
     read_levels, PLACE(levels)},
    {"no-contours", 0, NULL, "Draw no contours.", NULL, PLACE(no_contours)},
    {"records", 0, NULL, "On a sheet: mark the records of the cache.", NULL,
     PLACE(records)},
    {"grid", 0, NULL,
     "On a sheet with a fisheye view: overlay altitudes, compass points and the "
     "outlines of the openings.",
     NULL, PLACE(grid)},
    {"from-picture", 0, "FILE.hdr", "Display this picture instead of a room.",
     pp_options_read_input, PLACE(from_picture)},
    {"format", 'f', "FORMAT",
     "hdr, pfm, png, pdf or svg (default: from the extension of -o FILE).",
     read_picture_format, PLACE(format)},
    {"paper", 0, "SIZE", "Paper size of a sheet: a5, a4 (default), a3 or a2.",
     read_paper, PLACE(paper)},
    {"orientation", 0, "WAY", "portrait or landscape (default: whichever fits best).",
     pp_sheet_options_read_orientation, PLACE(orientation)},
    {"dpi", 0, "N",
     "Resolution of a PNG sheet in dots per inch, 20 to 1200 (default 200).",
     pp_sheet_options_read_dpi, PLACE(dpi)},
    {0},
};
