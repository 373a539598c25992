/* rad_gensky.c - the formulae of Radiance's sky generator [WS98].
 *
 * Position of the sun, for latitude phi, solar declination delta and solar time t:
 *
 *     sin altitude = sin phi sin delta - cos phi cos delta cos(15 deg t)
 *
 * delta = 0.4093 sin(2 pi (J - 81)/365) and the equation of time depend on the day J of
 * the year; with -y they follow Michalsky [MIC88]. Zenith and ground brightness follow
 * from the sun's altitude, or from -b or -B.
 */
#include "formats/radiance/read/rad_gensky.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/text.h"

/* Luminous efficacy of skylight and sunlight (lm/W), to convert the formulae's cd/m2 to
 * radiance. */
static const double sky_efficacy = 203.0, sun_efficacy = 208.0;

struct gensky_options {
    int type; /* enum pp_gensky_kind */
    bool sun; /* true if the sun is part of the scene */
    bool by_angle, solar_time, has_meridian;
    int month, day, year;
    double hour;
    double interval_h;                    /* of gendaylit's -i; 0: none */
    double altitude, azimuth;             /* rad; azimuth west of south */
    double latitude, longitude, meridian; /* rad; west is positive */
    double turbidity, ground;
    double zenith, zenith_horizontal; /* options -b and -B; NAN: not given */
    double solar, solar_horizontal;   /* options -r and -R */
};

/* ---- options ---- */

static bool complain(char *wrong, size_t room, const char *what, const char *word)
{
    snprintf(wrong, room, "%s%.60s", what, word);
    return false;
}

/* Reads "9", "9.5" or "9:30". A "+" before it means solar time. A time zone may follow
 * a time without "+". False if the word is invalid. */
static bool read_hour(struct gensky_options *asked, const char *word)
{
    static const struct {
        const char *name;
        double meridian;
    } zones[] = {{"YST", 135},  {"YDT", 120},  {"PST", 120}, {"PDT", 105},
                 {"MST", 105},  {"MDT", 90},   {"CST", 90},  {"CDT", 75},
                 {"EST", 75},   {"EDT", 60},   {"AST", 60},  {"ADT", 45},
                 {"NST", 52.5}, {"NDT", 37.5}, {"GMT", 0},   {"BST", -15},
                 {"CET", -15},  {"CEST", -30}, {"EET", -30}, {"EEST", -45}};
    asked->solar_time = *word == '+';
    word += asked->solar_time;
    char digits[16];
    size_t length = strspn(word, "0123456789.:");
    if (length == 0 || length >= sizeof digits)
        return false;
    memcpy(digits, word, length);
    digits[length] = '\0';
    char *colon = strchr(digits, ':');
    double minutes = 0.0;
    if (colon) {
        *colon = '\0';
        if (!pp_text_parse_number(colon + 1, &minutes) || !(minutes < 60.0))
            return false;
    }
    if (!pp_text_parse_number(digits, &asked->hour) || asked->hour > 24.0)
        return false;
    asked->hour += minutes / 60.0;
    if (word[length] == '\0')
        return true;
    for (size_t i = 0; i < sizeof zones / sizeof *zones && !asked->solar_time; i++)
        if (strcmp(word + length, zones[i].name) == 0) {
            asked->meridian = zones[i].meridian * PP_RAD;
            return asked->has_meridian = true;
        }
    return false;
}

static bool whole(const char *word, int least, int most, int *value)
{
    double number;
    if (!pp_text_parse_number(word, &number) || !(number >= least) || !(number <= most))
        return false;
    *value = (int)number;
    return number == *value;
}

static bool read_place(struct gensky_options *asked, char *const *words, int count)
{
    double altitude, azimuth;
    if (count < 4)
        return false;
    asked->by_angle = strcmp(words[1], "-ang") == 0;
    if (!asked->by_angle)
        return whole(words[1], 1, 12, &asked->month)
               && whole(words[2], 1, 31, &asked->day) && read_hour(asked, words[3]);
    if (!pp_text_parse_number(words[2], &altitude)
        || !pp_text_parse_number(words[3], &azimuth) || fabs(altitude) > 90.0
        || fabs(azimuth) > 720.0)
        return false;
    asked->altitude = altitude * PP_RAD;
    asked->azimuth = azimuth * PP_RAD;
    return true;
}

/* Sets an option that has one number; false if the number is invalid. */
static bool set_number(struct gensky_options *asked, char letter, double number)
{
    switch (letter) {
    case 'y':
        if (!(number >= 1950.0 && number <= 2050.0))
            return false; /* this range is checked before the conversion to int */
        asked->year = (int)number;
        return number == asked->year;
    case 'r':
        asked->solar = number;
        return number >= 0.0;
    case 'R':
        asked->solar_horizontal = number;
        return number >= 0.0;
    case 't':
        asked->turbidity = number;
        return number > 0.0;
    case 'b':
        asked->zenith = number;
        return number >= 0.0;
    case 'B':
        asked->zenith_horizontal = number;
        return number >= 0.0;
    case 'g':
        asked->ground = number;
        return number >= 0.0 && number <= 1.0;
    case 'a':
        asked->latitude = number * PP_RAD;
        return fabs(number) <= 90.0;
    case 'o':
        asked->longitude = number * PP_RAD;
        return fabs(number) <= 360.0;
    case 'm':
        if (!asked->has_meridian)
            asked->meridian = number * PP_RAD;
        return fabs(number) <= 360.0;
    default:
        return false;
    }
}

static bool read_options(struct gensky_options *asked, char *const *words, int count,
                         char *wrong, size_t room)
{
    for (int i = 4; i < count; i++) {
        const char *word = words[i];
        bool plus = word[0] == '+';
        if ((word[0] != '-' && !plus) || word[1] == '\0' || word[2] != '\0')
            return complain(wrong, room, "gensky has no option ", word);
        switch (word[1]) {
        case 's':
        case 'i':
            asked->type = word[1] == 's' ? PP_GENSKY_CLEAR : PP_GENSKY_INTERMEDIATE;
            asked->sun = plus;
            continue;
        case 'c':
            asked->type = PP_GENSKY_OVERCAST;
            continue;
        case 'u':
            asked->type = PP_GENSKY_UNIFORM;
            continue;
        }
        double number;
        if (!strchr("yrRtbBgaom", word[1]))
            return complain(wrong, room, "gensky has no option ", word);
        if (i + 1 >= count || !pp_text_parse_number(words[i + 1], &number)
            || !set_number(asked, word[1], number))
            return complain(wrong, room,
                            "expected a valid number after gensky's option ", word);
        i++;
    }
    return true;
}

/* ---- the sun ---- */

static double day_of_year(int month, int day)
{
    static const int before[] = {0, 31, 59, 90, 120, 151, 181, 212, 243, 273, 304, 334};
    return before[month - 1] + day;
}

static double round_the_circle(double x, double period)
{
    return x - period * floor(x / period);
}

/* Solar declination (rad) by the low-precision formula of the almanac [MIC88]. Sets
 * *solar_time (h) from standard time, unless the time given is solar time. */
static double declination_of_year(const struct gensky_options *asked,
                                  double *solar_time)
{
    int year = asked->year;
    double days = day_of_year(asked->month, asked->day)
                  + (asked->month > 2 && year % 4 == 0) + (year - 1949) * 365
                  + (year - 1949) / 4;
    double hours = asked->hour + asked->meridian * 12.0 / PP_PI;
    double n =
        days + hours / 24.0 + (2432916.5 - 2451545.0); /* days from noon, 2000-01-01 */
    double mean = round_the_circle((280.460 + 0.9856474 * n) * PP_RAD, 2.0 * PP_PI);
    double g = round_the_circle((357.528 + 0.9856003 * n) * PP_RAD, 2.0 * PP_PI);
    double l = mean + 1.915 * PP_RAD * sin(g) + 0.020 * PP_RAD * sin(2.0 * g);
    double obliquity = (23.439 - 4e-7 * n) * PP_RAD;
    if (!asked->solar_time) {
        double ascension = atan2(sin(l) * cos(obliquity), cos(l));
        double sidereal = 6.697375 + 0.0657098242 * n + 24.0 * (n - floor(n)) + 12.0;
        double local = sidereal - asked->longitude * 12.0 / PP_PI;
        *solar_time = round_the_circle(local - ascension * 12.0 / PP_PI + 12.0, 24.0);
    }
    return asin(sin(obliquity) * sin(l));
}

/* Moves the solar time (h) of an interval with sunrise or sunset to the middle of its
 * sunlit part, as gendaylit does. plain: declination without -y. */
static double middle_of_sunlit_part(const struct gensky_options *asked, double plain,
                                    double time)
{
    double half = 0.5 * asked->interval_h;
    double noon_to_set = acos(-tan(asked->latitude) * tan(plain)) * 12.0 / PP_PI;
    double rise = 12.0 - noon_to_set, set = 12.0 + noon_to_set;
    if (half > 0.0 && fabs(rise - time) <= half) /* false where there is no sunrise */
        time = 0.5 * (time + half + rise);
    if (half > 0.0 && fabs(set - time) < half)
        time = 0.5 * (time - half + set);
    return time;
}

static void place_sun(struct gensky_options *asked)
{
    double time = asked->hour, declination;
    double day = day_of_year(asked->month, asked->day);
    double plain = 0.4093 * sin(2.0 * PP_PI / 365.0 * (day - 81.0));
    if (asked->year) {
        declination = declination_of_year(asked, &time);
    } else {
        declination = plain;
        if (!asked->solar_time)
            time += 0.170 * sin(4.0 * PP_PI / 373.0 * (day - 80.0))
                    - 0.129 * sin(2.0 * PP_PI / 355.0 * (day - 8.0))
                    + 12.0 / PP_PI * (asked->meridian - asked->longitude);
    }
    time = middle_of_sunlit_part(asked, plain, time);
    double s = sin(asked->latitude), c = cos(asked->latitude);
    double turn = time * PP_PI / 12.0;
    asked->altitude = asin(s * sin(declination) - c * cos(declination) * cos(turn));
    asked->azimuth = -atan2(cos(declination) * sin(turn),
                            -c * sin(declination) - s * cos(declination) * cos(turn));
}

/* ---- brightness ---- */

/* Rounds to four significant digits, as gensky prints them. */
static double printed(double value)
{
    char text[40];
    snprintf(text, sizeof text, "%.3e", value);
    return pp_text_parse_number(text, &value) ? value : 0.0;
}

static double printed_part(double value)
{
    char text[40];
    snprintf(text, sizeof text, "%f", value);
    return pp_text_parse_number(text, &value) ? value : 0.0;
}

/* Horizontal illuminance over zenith luminance, in the units of the formulae, by
 * gensky's polynomials in the sun's altitude. */
static double horizontal_over_zenith(int type, double altitude)
{
    static const double clear[] = {2.766521, 0.547665, -0.369832, 0.009237, 0.059229};
    static const double between[] = {3.5556, -2.7152, -1.3081, 1.0660, 0.60227};
    const double *terms = type == PP_GENSKY_INTERMEDIATE ? between : clear;
    double x = (altitude - PP_PI / 4.0) / (PP_PI / 4.0), sum = terms[4];
    for (int i = 3; i >= 0; i--)
        sum = sum * x + terms[i];
    return sum;
}

/* Value of the sky's gradation formula at the zenith, by which the sky is
 * normalised. */
static double zenith_scale(int type, double altitude)
{
    double away = PP_PI / 2.0 - altitude, s = sin(altitude);
    if (type == PP_GENSKY_CLEAR)
        return 0.274 * (0.91 + 10.0 * exp(-3.0 * away) + 0.45 * s * s);
    return (2.739 + 0.9891 * sin(0.3119 + 2.6 * altitude))
           * exp(-away * (0.4441 + 1.48 * altitude));
}

double pp_rad_gensky_level(int type, double altitude)
{
    if (type == PP_GENSKY_UNIFORM)
        return 1.0;
    if (type == PP_GENSKY_OVERCAST)
        return 0.777778;
    return horizontal_over_zenith(type, altitude) / zenith_scale(type, altitude)
           / PP_PI;
}

static double zenith_of(const struct gensky_options *asked, bool even, double level)
{
    if (!isnan(asked->zenith_horizontal))
        return asked->zenith_horizontal / (level * PP_PI);
    if (!isnan(asked->zenith))
        return asked->zenith;
    double dull = 8.6 * sin(asked->altitude) + 0.123; /* kcd/m2 */
    double clear = (1.376 * asked->turbidity - 1.81) * tan(asked->altitude) + 0.38;
    double kcd = even                                    ? dull
                 : asked->type == PP_GENSKY_INTERMEDIATE ? (clear + dull) / 2.0
                                                         : clear;
    return fmax(kcd, 0.0) * 1000.0 / sky_efficacy;
}

static double sun_of(const struct gensky_options *asked, double s)
{
    if (!isnan(asked->solar_horizontal))
        return asked->solar_horizontal / (5.98e-5 * s);
    if (!isnan(asked->solar))
        return asked->solar;
    double radiance = 1.5e9 / sun_efficacy * (1.147 - 0.147 / fmax(s, 0.16));
    return asked->type == PP_GENSKY_INTERMEDIATE ? 0.15 * radiance : radiance;
}

static void set_brightness(struct pp_gensky *sky, struct gensky_options *asked)
{
    int type = asked->type;
    bool even = type == PP_GENSKY_OVERCAST || type == PP_GENSKY_UNIFORM;
    if (!even)
        asked->altitude = fmin(asked->altitude, 87.0 * PP_RAD);
    double c = cos(asked->altitude), s = sin(asked->altitude);
    double scale = even ? 1.0 : zenith_scale(type, asked->altitude);
    double level = pp_rad_gensky_level(type, asked->altitude);
    double zenith = zenith_of(asked, even, level), ground = zenith * level;
    double sun = even || !(s > 0.0) ? 0.0 : sun_of(asked, s);
    if (sun > 0.0)
        ground += 6e-5 / PP_PI * sun * s;
    ground *= asked->ground;
    *sky = (struct pp_gensky){
        .pattern = {.kind = PP_PATTERN_GENSKY,
                    .type = (enum pp_gensky_kind)type,
                    .zenith = printed(zenith),
                    .ground = printed(ground),
                    .norm = even ? 1.0 : printed(scale),
                    .sun = {printed_part(-sin(asked->azimuth) * c),
                            printed_part(-cos(asked->azimuth) * c), printed_part(s)}},
        .has_sun = asked->sun && sun > 0.0,
        .sun_radiance = printed(sun),
        .sun_half_rad = 0.25 * PP_RAD};
    if (even)
        sky->pattern.sun = pp_vec(0.0, 0.0, 1.0);
    else
        sky->pattern.sun = pp_vec_unit(sky->pattern.sun);
}

/* Sets the defaults and reads all words. Does not place the sun. */
static bool read_all(struct gensky_options *asked, char *const *words, int count,
                     char *wrong, size_t room)
{
    *asked = (struct gensky_options){.type = PP_GENSKY_CLEAR,
                                     .sun = true,
                                     .latitude = 0.66,
                                     .longitude = 2.13,
                                     .meridian = 120.0 * PP_RAD,
                                     .turbidity = 2.45,
                                     .ground = 0.2,
                                     .zenith = NAN,
                                     .zenith_horizontal = NAN,
                                     .solar = NAN,
                                     .solar_horizontal = NAN};
    if (!read_place(asked, words, count)) {
        snprintf(wrong, room,
                 "expected %.20s with month, day and hour, or with -ang, altitude and "
                 "azimuth",
                 words[0]);
        return false;
    }
    if (!read_options(asked, words, count, wrong, room))
        return false;
    return true;
}

bool pp_rad_gensky_place(double *altitude, double *azimuth, int *day,
                         double interval_min, char *const *words, int count,
                         char *wrong, size_t room)
{
    struct gensky_options asked;
    if (!read_all(&asked, words, count, wrong, room))
        return false;
    asked.interval_h = interval_min / 60.0;
    if (!asked.by_angle)
        place_sun(&asked);
    *altitude = asked.altitude;
    *azimuth = asked.azimuth;
    *day = asked.by_angle ? 0 : (int)day_of_year(asked.month, asked.day);
    return true;
}

bool pp_rad_gensky_evaluate(struct pp_gensky *sky, char *const *words, int count,
                            char *wrong, size_t room)
{
    struct gensky_options asked;
    if (!read_all(&asked, words, count, wrong, room))
        return false;
    if (!asked.by_angle)
        place_sun(&asked);
    set_brightness(sky, &asked);
    return true;
}
