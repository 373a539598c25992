/* sky_words.h - a sky in words, as in a room file's <sky> and the command line's --sky:
 * "overcast", "uniform", "iso-1" to "iso-15", and the position of the sun; "picture", and
 * its file. */
#ifndef PP_MODEL_ROOM_SKY_WORDS_H
#define PP_MODEL_ROOM_SKY_WORDS_H

#include "model/base/error.h"
#include "model/light/sky.h"

/* Sky as the words state it, before it becomes a sky. */
struct pp_sky_part {
    enum pp_sky_kind kind;
    int iso;
    double sun_altitude_rad, sun_bearing_rad; /* NAN where not given */
    struct pp_sky_picture *picture;           /* of PP_SKY_PICTURE; held by the part */
    int line;                                 /* of the room file; 0: none */
};

/* The words for types, ended by NULL; their places are pp_sky_words_set_type's. */
extern const char *const pp_sky_words[];

/* An overcast sky, and nothing said of the sun. */
struct pp_sky_part pp_sky_words_default(void);

/* Another part that holds the same picture, and the end of one. */
struct pp_sky_part pp_sky_words_copy(const struct pp_sky_part *part);
void pp_sky_words_clear(struct pp_sky_part *part);

/* Gives the part the type of that index among pp_sky_words. */
void pp_sky_words_set_type(struct pp_sky_part *part, int index);

/* Reads "TYPE" or "TYPE,SUN-ALTITUDE,SUN-BEARING", in degrees ("iso-12,30,180").
 * Without a sun the part keeps its own. Or reads "picture,FILE" or
 * "picture,FILE,KEY=VALUE..." (sky_picture_file.h), and the file. PP_BAD_INPUT where a
 * type needs the sun and neither has one, or the file can't be read; the part stays as
 * it was. */
enum pp_status pp_sky_words_parse(struct pp_sky_part *part, const char *spec,
                                  struct pp_error *err);

/* Sky in the axes of a room whose +y points to the bearing north_rad. PP_BAD_INPUT if
 * it needs a sun that is not given. */
enum pp_status pp_sky_words_sky(struct pp_sky *sky, const struct pp_sky_part *part,
                                double north_rad, struct pp_error *err);

#endif
