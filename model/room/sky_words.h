/* sky_words.h - a sky in words, as in a room file's <sky> and the option --sky:
 * "overcast", "uniform", "iso-1" to "iso-15" with the position of the sun, or "picture"
 * with its file. */
#ifndef PP_MODEL_ROOM_SKY_WORDS_H
#define PP_MODEL_ROOM_SKY_WORDS_H

#include "model/base/error.h"
#include "model/light/sky.h"

/* Description of a sky, from which pp_sky_words_sky makes the sky. */
struct pp_sky_part {
    enum pp_sky_kind kind;
    int iso;
    double sun_altitude_rad, sun_bearing_rad; /* NAN: not given */
    struct pp_sky_picture *picture;           /* for PP_SKY_PICTURE; the part holds a
                                               * reference */
    int line;                                 /* line of the room file; 0: none */
};

/* Names of the types, NULL-terminated; indices as in pp_sky_words_set_type. */
extern const char *const pp_sky_words[];

/* An overcast sky without a sun. */
struct pp_sky_part pp_sky_words_default(void);

/* Copies a part, with a new reference to its picture; pp_sky_words_clear releases the
 * reference. */
struct pp_sky_part pp_sky_words_copy(const struct pp_sky_part *part);
void pp_sky_words_clear(struct pp_sky_part *part);

/* Sets the type with that index in pp_sky_words. */
void pp_sky_words_set_type(struct pp_sky_part *part, int index);

/* Reads "TYPE" or "TYPE,SUN-ALTITUDE,SUN-BEARING", in degrees ("iso-12,30,180").
 * Without a sun the part keeps its own. Also reads "picture,FILE" or
 * "picture,FILE,KEY=VALUE..." (sky_picture_file.h), including the file. PP_BAD_INPUT if
 * the text is not valid, or if the type needs a sun and there is none. The part is
 * unchanged after a failure. */
enum pp_status pp_sky_words_parse(struct pp_sky_part *part, const char *spec,
                                  struct pp_error *err);

/* Makes the sky in the axes of a room whose +y has the bearing north_rad. PP_BAD_INPUT
 * if the sky needs a sun that is not given or is below the horizon. */
enum pp_status pp_sky_words_sky(struct pp_sky *sky, const struct pp_sky_part *part,
                                double north_rad, struct pp_error *err);

#endif
