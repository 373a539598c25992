/* overlay_sun.c - lines of a declination and lines of an hour. */
#include "charts/sky/overlay_sun.h"

#include <math.h>
#include <stdio.h>

#include "model/light/sun_path.h"

/* One path for each declination; those of later months are within 0.6 degrees of the
 * earlier ones. */
static const struct {
    int month;
    const char *words;
} paths[] = {{12, "Dec"},     {1, "Jan, Nov"}, {2, "Feb, Oct"}, {3, "Mar, Sep"},
             {4, "Apr, Aug"}, {5, "May, Jul"}, {6, "Jun"}};
enum { PATHS = sizeof paths / sizeof paths[0], DAY = 21, STEPS = 120 };

/* A direction's place; false below the horizon. */
static bool place_sun(const struct pp_overlay_plot *plot, double declination,
                      double hour, double xy[2])
{
    struct pp_vec3 u =
        pp_sun_path_direction(plot->overlay->latitude_rad, declination, hour);
    double altitude = asin(fmin(fmax(u.z, -1.0), 1.0));
    pp_overlay_plot_place(plot, fmax(altitude, 0.0), atan2(u.x, u.y), xy);
    return altitude > -1e-9;
}

static void draw_path(const struct pp_overlay_plot *plot, double declination)
{
    double sunset = pp_sun_path_sunset(plot->overlay->latitude_rad, declination);
    if (!(sunset > 0.0))
        return;
    for (int i = 0; i <= STEPS; i++) {
        double xy[2];
        place_sun(plot, declination, sunset * (2.0 * i / STEPS - 1.0), xy);
        cairo_line_to(plot->cr, xy[0], xy[1]);
    }
    pp_overlay_plot_stroke(plot, plot->style.medium);
}

/* Draws an hour line from the December sun path to the June one, where the sun is
 * up. */
static void draw_hour(const struct pp_overlay_plot *plot, int hour)
{
    double low = pp_sun_path_declination(12, DAY),
           high = pp_sun_path_declination(6, DAY);
    for (int i = 0; i <= STEPS; i++) {
        double xy[2], declination = low + (high - low) * i / STEPS;
        if (place_sun(plot, declination, (hour - 12) * 15.0 * PP_RAD, xy))
            cairo_line_to(plot->cr, xy[0], xy[1]);
        else
            cairo_new_sub_path(plot->cr);
    }
    pp_labels_note_path(plot->labels, plot->cr, -1);
    pp_overlay_plot_stroke(plot, plot->style.thin);
}

/* Writes the words on white, if the place is still free. */
static void put_words(const struct pp_overlay_plot *plot, const double xy[2],
                      const char *words)
{
    const struct pp_lettering set = {.size = PP_TEXT_SMALL, .across = 0.5, .down = 0.5};
    struct pp_box box =
        pp_lettering_measure(plot->cr, &plot->style, &set, xy[0], xy[1], words);
    for (int i = 0; i < plot->labels->count; i++)
        if (plot->labels->places[i].owner == 1
            && pp_lettering_boxes_overlap(
                box, (struct pp_box){plot->labels->places[i].x,
                                     plot->labels->places[i].y, 1e-6, 1e-6}))
            return;
    pp_lettering_draw_on_white(plot->cr, &plot->style, &set, xy[0], xy[1], words);
    for (double x = box.x; x <= box.x + box.width; x += 0.5)
        pp_labels_note(plot->labels, 1, x, box.y, x, box.y + box.height);
}

/* Months on their paths, in the afternoon and between two hours; hours outside the longest
 * day's path. */
static void name_lines(const struct pp_overlay_plot *plot)
{
    double latitude = plot->overlay->latitude_rad;
    double summer = pp_sun_path_declination(latitude < 0.0 ? 12 : 6, DAY);
    double xy[2];
    char words[16];
    for (int hour = 1; hour < 24; hour++) {
        double angle = (hour - 12) * 15.0 * PP_RAD;
        if (fabs(angle) > pp_sun_path_sunset(latitude, summer) - 2.0 * PP_RAD)
            continue;
        struct pp_vec3 u = pp_sun_path_direction(latitude, summer, angle);
        pp_overlay_plot_place(plot, fmin(asin(u.z) + 3.5 * PP_RAD, 0.5 * PP_PI),
                              atan2(u.x, u.y), xy);
        snprintf(words, sizeof words, "%d", hour);
        put_words(plot, xy, words);
    }
    for (int i = 0; i < PATHS; i++)
        for (int hour = 0; hour < 4; hour++) {
            double angle = (hour + 0.5) * 15.0 * PP_RAD;
            double declination = pp_sun_path_declination(paths[i].month, DAY);
            int before = plot->labels->count;
            if (angle > pp_sun_path_sunset(latitude, declination))
                break;
            if (place_sun(plot, declination, angle, xy))
                put_words(plot, xy, paths[i].words);
            if (plot->labels->count > before)
                break;
        }
}

void pp_overlay_sun_draw(const struct pp_overlay_plot *plot)
{
    for (int hour = 0; hour < 24; hour++)
        draw_hour(plot, hour);
    for (int i = 0; i < PATHS; i++)
        draw_path(plot, pp_sun_path_declination(paths[i].month, DAY));
    name_lines(plot);
}
