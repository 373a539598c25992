/* rad_gendaylit.c - normalises Perez's sky as gendaylit does: by the centres of
 * Tregenza's 145 patches, as if all were of one size. */
#include "formats/radiance/read/rad_gendaylit.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "model/base/text.h"
#include "model/light/perez_sky.h"

enum { PLACE_WORDS = 12 };

struct gendaylit_options {
    char *place[PLACE_WORDS]; /* place and time, for pp_rad_gensky_place */
    int place_count;
    bool sun;             /* true if the sun is part of the scene */
    char input;           /* 'W', 'G', 'L', 'P' or 'E'; 0: not given */
    double first, second; /* numbers of that option */
    double interval_min;  /* -i; 0: not given */
    bool colour;          /* -C */
    double dew_point_c, ground;
    int output; /* 0: visible radiation, 1: all solar radiation */
};

static bool complain_of(char *wrong, size_t room, const char *what, const char *word)
{
    snprintf(wrong, room, "%s%.60s", what, word);
    return false;
}

/* Reads the one or two numbers of an option; false if any is not valid. */
static bool set_numbers(struct gendaylit_options *asked, char letter, const double *n)
{
    switch (letter) {
    case 'W':
    case 'G':
    case 'L':
    case 'P':
    case 'E':
        asked->input = letter;
        asked->first = n[0];
        asked->second = letter == 'E' ? 0.0 : n[1];
        return asked->first >= 0.0 && asked->second >= 0.0;
    case 'i':
        asked->interval_min = n[0];
        return n[0] >= 0.0;
    case 'd':
        asked->dew_point_c = n[0];
        return n[0] >= -40.0 && n[0] <= 40.0;
    case 'g':
        asked->ground = n[0];
        return n[0] >= 0.0 && n[0] <= 1.0;
    default: /* -O */
        asked->output = (int)n[0];
        return n[0] == 0.0 || n[0] == 1.0;
    }
}

static bool read_gendaylit(struct gendaylit_options *asked, char *const *words,
                           int count, char *wrong, size_t room)
{
    for (int i = 0; i < count && i < 4; i++)
        asked->place[asked->place_count++] = words[i];
    for (int i = 4; i < count; i++) {
        const char *word = words[i];
        bool is_option = (word[0] == '-' || word[0] == '+') && word[1] && !word[2];
        char letter = is_option ? word[1] : '\0';
        double n[2];
        if (letter == 's') {
            asked->sun = word[0] == '+';
        } else if (letter && strchr("yaom", letter) && i + 1 < count
                   && asked->place_count + 2 <= PLACE_WORDS) {
            asked->place[asked->place_count++] = words[i++];
            asked->place[asked->place_count++] = words[i];
        } else if (letter && strchr("WGLPEidgO", letter)) {
            int numbers = strchr("WGLP", letter) ? 2 : 1;
            bool good = i + numbers < count;
            for (int k = 0; k < numbers && good; k++)
                good = pp_text_parse_number(words[i + 1 + k], &n[k]);
            if (!good || !set_numbers(asked, letter, n))
                return complain_of(wrong, room,
                                   "expected valid numbers after gendaylit's option ",
                                   word);
            i += numbers;
        } else if (letter == 'C') {
            asked->colour = true;
        } else if (letter != 'w' && strcmp(word, "-CIE") != 0) {
            return complain_of(wrong, room,
                               "expected -W, -G, -L, -P or -E, and not gendaylit's "
                               "option ",
                               word);
        }
    }
    if (!asked->input)
        return complain_of(wrong, room, "expected gendaylit with -W, -G, -L, -P or -E",
                           "");
    return true;
}

/* 1 over the square of the sun's distance in astronomical units, by day of the year
 * (Spencer 1971); day 0 with -ang. */
static double eccentricity(int day)
{
    double a = 2.0 * PP_PI * (day - 1) / 365.0;
    return 1.00011 + 0.034221 * cos(a) + 0.00128 * sin(a) + 0.000719 * cos(2.0 * a)
           + 0.000077 * sin(2.0 * a);
}

/* Luminance in a direction at these angles to zenith and sun, by (1) in perez_sky.h
 * with N = 1. */
static double relative_luminance(const struct pp_perez_sky *sky, double zenith,
                                 double gamma)
{
    double to_sun = cos(gamma);
    return (1.0 + sky->a * exp(sky->b / cos(zenith)))
           * (1.0 + sky->c * exp(sky->d * gamma) + sky->e * to_sun * to_sun);
}

/* Horizontal illuminance with N = 1, from the centres of the patches. */
static double patch_integral(const struct pp_perez_sky *sky, double altitude)
{
    static const int rings[] = {30, 30, 24, 24, 18, 12, 6, 1};
    double sum = 0.0;
    for (int r = 0; r < 8; r++)
        for (int i = 0; i < rings[r]; i++) {
            double zenith = (r < 7 ? 84.0 - 12.0 * r : 0.0) * PP_RAD;
            double turn = 2.0 * PP_PI * i / rings[r];
            double c =
                sin(altitude) * cos(zenith) + cos(altitude) * sin(zenith) * cos(turn);
            sum += relative_luminance(sky, zenith, acos(fmin(c, 1.0))) * cos(zenith);
        }
    return sum * 2.0 * PP_PI / 145.0;
}

static double rounded(double value, const char *format)
{
    char text[40];
    snprintf(text, sizeof text, format, value);
    return pp_text_parse_number(text, &value) ? value : 0.0;
}

static void set_sky(struct pp_gensky *sky, const struct gendaylit_options *asked,
                    const struct pp_perez_conditions *weather,
                    const struct pp_perez_sky *perez, double altitude,
                    struct pp_vec3 sun)
{
    static const double half_sun = 0.2665 * PP_RAD, efficacy = 179.0;
    double factor =
        asked->output == 1 ? weather->diffuse_w_m2 : perez->diffuse_lx / efficacy;
    factor /= patch_integral(perez, altitude);
    double direct =
        asked->output == 1 ? weather->direct_w_m2 : perez->direct_lx / efficacy;
    double radiance = direct / (2.0 * PP_PI * (1.0 - cos(half_sun)));
    bool shines = asked->sun && perez->clearness > 1.0;
    int type = !(perez->clearness > 1.0) ? PP_GENSKY_OVERCAST
               : perez->clearness >= 6.0 ? PP_GENSKY_CLEAR
                                         : PP_GENSKY_INTERMEDIATE;
    double ground = factor * relative_luminance(perez, 0.0, PP_PI / 2.0 - altitude)
                    * pp_rad_gensky_level(type, altitude);
    if (shines)
        ground += 6.8e-5 / PP_PI * radiance * sin(altitude);
    *sky = (struct pp_gensky){
        .pattern = {.kind = PP_PATTERN_GENSKY,
                    .type = PP_GENSKY_PEREZ,
                    .zenith = rounded(factor, "%.3e"),
                    .ground = rounded(asked->ground * ground, "%.3e"),
                    .norm = 1.0,
                    .perez = {perez->a, perez->b, perez->c, perez->d, perez->e}},
        .has_sun = shines && radiance > 0.0,
        .sun_radiance = rounded(radiance, "%.3e"),
        .sun_half_rad = half_sun};
    for (int i = 0; i < 5; i++)
        sky->pattern.perez[i] = rounded(sky->pattern.perez[i], "%f");
    sky->pattern.sun = pp_vec_unit(
        pp_vec(rounded(sun.x, "%f"), rounded(sun.y, "%f"), rounded(sun.z, "%f")));
}

/* Fraction of the global irradiance that is diffuse, by clearness index [EKD82]. */
static double erbs_fraction(double kt)
{
    if (kt <= 0.22)
        return 1.0 - 0.09 * kt;
    if (kt > 0.8)
        return 0.165;
    return 0.9511 + kt * (-0.1604 + kt * (4.388 + kt * (-16.638 + kt * 12.336)));
}

/* Illuminance by the sun outside the atmosphere, as in gendaylit. */
static const double solar_lx = 127500.0;

/* Finds the irradiances whose sky has these illuminances (lx). The luminous efficacies
 * depend on the irradiances, so that they are found by iteration. Like gendaylit, this
 * stops after nine steps; near the limits of a bin the values need not converge. */
static void find_irradiances(struct pp_perez_conditions *weather, double direct_lx,
                             double diffuse_lx)
{
    static const double least_w_m2 = 1e-6;
    weather->direct_w_m2 = direct_lx * PP_PEREZ_SKY_SOLAR_W_M2 / solar_lx;
    weather->diffuse_w_m2 = diffuse_lx * PP_PEREZ_SKY_SOLAR_W_M2 / solar_lx;
    for (int i = 0; i < 9 && diffuse_lx > 0.0; i++) {
        struct pp_perez_conditions now = *weather;
        now.direct_w_m2 = fmax(now.direct_w_m2, least_w_m2);
        struct pp_perez_sky sky = pp_perez_sky_of(&now);
        double efficacy = sky.direct_lx / now.direct_w_m2;
        weather->diffuse_w_m2 = diffuse_lx * now.diffuse_w_m2 / sky.diffuse_lx;
        weather->direct_w_m2 = efficacy < 0.1 ? 0.0 : direct_lx / efficacy;
    }
}

/* Irradiances (W/m2) of the options. */
static void set_irradiances(struct pp_perez_conditions *weather,
                            const struct gendaylit_options *asked, double altitude)
{
    double distance = weather->sun_distance_au, global = asked->first;
    double outside = PP_PEREZ_SKY_SOLAR_W_M2 / (distance * distance) * sin(altitude);
    switch (asked->input) {
    case 'P': /* within the limits of the model; eps above 12.01 becomes 12.009, as in
               * gendaylit */
        pp_perez_sky_irradiances(
            &weather->direct_w_m2, &weather->diffuse_w_m2,
            asked->first > 12.01 ? 12.009 : fmax(asked->first, 1.0),
            fmin(fmax(asked->second, 0.01), 0.6), altitude, distance);
        return;
    case 'L':
        find_irradiances(weather, asked->first, asked->second);
        return;
    case 'E':
        if (global > outside)
            global = 0.999 * outside;
        weather->diffuse_w_m2 = global * erbs_fraction(global / outside);
        weather->direct_w_m2 = (global - weather->diffuse_w_m2) / sin(altitude);
        return;
    default:
        weather->direct_w_m2 =
            asked->input == 'G' ? asked->first / sin(altitude) : asked->first;
        weather->diffuse_w_m2 = asked->second;
    }
}

bool pp_rad_gendaylit_evaluate(struct pp_gensky *sky, char *const *words, int count,
                               char *wrong, size_t room)
{
    struct gendaylit_options asked = {
        .sun = true, .dew_point_c = 10.97353115, .ground = 0.2};
    double altitude, azimuth;
    int day;
    if (!read_gendaylit(&asked, words, count, wrong, room)
        || !pp_rad_gensky_place(&altitude, &azimuth, &day, asked.interval_min,
                                asked.place, asked.place_count, wrong, room))
        return false;
    if (!(altitude > 0.0))
        return complain_of(wrong, room,
                           "gendaylit's sun is below the horizon; expected a sun above "
                           "it",
                           "");
    altitude = fmin(altitude, 87.0 * PP_RAD);
    double c = cos(altitude);
    struct pp_vec3 sun = pp_vec(-sin(azimuth) * c, -cos(azimuth) * c, sin(altitude));
    struct pp_perez_conditions weather = {.sun = sun,
                                          .sun_distance_au =
                                              1.0 / sqrt(eccentricity(day)),
                                          .dew_point_c = asked.dew_point_c};
    set_irradiances(&weather, &asked, altitude);
    struct pp_perez_sky perez = pp_perez_sky_of(&weather);
    if (asked.input == 'L') {
        perez.direct_lx = asked.first;
        perez.diffuse_lx = asked.second;
    }
    if (perez.limits & PP_PEREZ_B_POSITIVE || !(weather.diffuse_w_m2 > 0.0)
        || weather.direct_w_m2 > PP_PEREZ_SKY_SOLAR_W_M2 || perez.direct_lx > solar_lx)
        return complain_of(
            wrong, room, "gendaylit has no sky for these values; expected others", "");
    if (asked.colour && !(perez.clearness > 1.065 && perez.clearness < 4.5))
        return complain_of(
            wrong, room, "expected a sky without colours, and not gendaylit's option ",
            "-C");
    set_sky(sky, &asked, &weather, &perez, altitude, sun);
    return true;
}
