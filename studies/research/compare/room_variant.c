/* room_variant.c - reads the switches of a variant; lists the presets. */
#include "studies/research/compare/room_variant.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

#include "model/base/text.h"
#include "model/room/sky_words.h"

enum { MOST_BOUNCES = 1000, WORD_BYTES = 64 };

static const struct pp_room_variant_preset presets[] = {
    {"rtrace-defaults", "ab=0", "rtrace without options: no ambient calculation"},
    {"low", "ab=2", "low quality in front ends: two ambient bounces"},
    {"medium", "ab=3", "medium quality in front ends: three ambient bounces"},
    {"high", "ab=6", "high quality in front ends: six ambient bounces"},
};
enum { PRESET_COUNT = sizeof presets / sizeof presets[0] };

const struct pp_room_variant_preset *pp_room_variant_preset_at(int index)
{
    return index < PRESET_COUNT ? &presets[index] : NULL;
}

struct pp_room_variant pp_room_variant_nothing(void)
{
    return (struct pp_room_variant){
        .bounces = -1, .plane_m = NAN, .ground = NAN, .factor = 1.0};
}

/* Reads a number from `least` to `most`, for the switch `name`. */
static enum pp_status read_switch_number(double *number, const char *name,
                                         const char *text, double least, double most,
                                         struct pp_error *err)
{
    double value;
    if (!pp_text_parse_number(text, &value) || !(value >= least && value <= most))
        return pp_fail(err, PP_BAD_INPUT,
                       "%s is \"%.40s\"; expected a number from %g to %g", name, text,
                       least, most);
    *number = value;
    return PP_OK;
}

static enum pp_status read_bounces(struct pp_room_variant *variant, const char *name,
                                   const char *text, struct pp_error *err)
{
    double value;
    bool letter = strcmp(name, "ab") == 0;
    if (!pp_text_parse_number(text, &value) || !(value >= 0.0 && value <= MOST_BOUNCES)
        || value != floor(value))
        return pp_fail(err, PP_BAD_INPUT,
                       "%s is \"%.40s\"; expected a whole number from 0 to %d", name,
                       text, MOST_BOUNCES);
    variant->dark = letter && value == 0.0;
    variant->ground_counts = letter;
    variant->bounces = (int)value - (letter && value > 0.0);
    return PP_OK;
}

static enum pp_status read_glass(struct pp_room_variant *variant, const char *text,
                                 struct pp_error *err)
{
    static const char *const words[] = {"normal", "transmissivity", "none"};
    for (int i = 0; i < 3; i++)
        if (strcmp(text, words[i]) == 0) {
            variant->glass =
                (enum pp_room_variant_glass)(PP_ROOM_VARIANT_GLASS_NORMAL + i);
            return PP_OK;
        }
    return pp_text_unknown(err, text, words, 3, NULL, "there is no glass \"%.40s\"",
                           text);
}

static enum pp_status read_colour(struct pp_room_variant *variant, const char *text,
                                  struct pp_error *err)
{
    static const char *const words[] = {"grey", "mean", "green"};
    for (int i = 0; i < 3; i++)
        if (strcmp(text, words[i]) == 0) {
            variant->colour =
                (enum pp_room_variant_colour)(PP_ROOM_VARIANT_COLOUR_GREY + i);
            return PP_OK;
        }
    return pp_text_unknown(err, text, words, 3, NULL, "there is no colour \"%.40s\"",
                           text);
}

/* Reads a sky type. A sky with a sun gets the position of the room's sun. */
static enum pp_status read_sky(struct pp_room_variant *variant, const char *text,
                               struct pp_error *err)
{
    const char *words[32] = {"gensky"};
    int count = 1;
    for (int i = 0; pp_sky_words[i] && count < 32; i++)
        if (strcmp(pp_sky_words[i], "picture") != 0)
            words[count++] = pp_sky_words[i];
    for (int i = 0; i < count; i++)
        if (strcmp(text, words[i]) == 0) {
            strcpy(variant->sky, words[i]);
            return PP_OK;
        }
    return pp_text_unknown(err, text, words, count, NULL, "there is no sky \"%.40s\"",
                           text);
}

/* Reads a setting that has only one possible value. */
static enum pp_status read_only(bool *place, const char *name, const char *text,
                                const char *value, struct pp_error *err)
{
    if (strcmp(text, value) != 0)
        return pp_fail(err, PP_BAD_INPUT, "%s is \"%.40s\"; expected %s", name, text,
                       value);
    *place = true;
    return PP_OK;
}

static enum pp_status read_switch(struct pp_room_variant *variant, const char *name,
                                  const char *text, struct pp_error *err)
{
    static const char *const names[] = {"bounces", "ab",      "glass",  "panes",
                                        "frame",   "dirt",    "plane",  "sky",
                                        "ground",  "outside", "colour", "factor"};
    if (strcmp(name, "bounces") == 0 || strcmp(name, "ab") == 0)
        return read_bounces(variant, name, text, err);
    if (strcmp(name, "glass") == 0)
        return read_glass(variant, text, err);
    if (strcmp(name, "colour") == 0)
        return read_colour(variant, text, err);
    if (strcmp(name, "panes") == 0)
        return read_only(&variant->one_pane, name, text, "1", err);
    if (strcmp(name, "frame") == 0)
        return read_only(&variant->no_frame, name, text, "none", err);
    if (strcmp(name, "dirt") == 0)
        return read_only(&variant->no_dirt, name, text, "none", err);
    if (strcmp(name, "plane") == 0)
        return read_switch_number(&variant->plane_m, name, text, 0.0, 100.0, err);
    if (strcmp(name, "sky") == 0)
        return read_sky(variant, text, err);
    if (strcmp(name, "ground") == 0 && strcmp(text, "open") == 0)
        return read_only(&variant->open_ground, name, text, "open", err);
    if (strcmp(name, "ground") == 0)
        return read_switch_number(&variant->ground, name, text, 0.0, 1.0, err);
    if (strcmp(name, "outside") == 0)
        return read_only(&variant->nothing_outside, name, text, "none", err);
    if (strcmp(name, "factor") == 0)
        return read_switch_number(&variant->factor, name, text, 0.01, 100.0, err);
    return pp_text_unknown(err, name, names, sizeof names / sizeof names[0], NULL,
                           "there is no switch \"%.40s\"", name);
}

static enum pp_status add_word(struct pp_room_variant *variant, const char *word,
                               size_t length, struct pp_error *err)
{
    char name[WORD_BYTES];
    if (length >= sizeof name)
        return pp_fail(err, PP_BAD_INPUT, "\"%.40s...\" is not a switch", word);
    memcpy(name, word, length);
    name[length] = '\0';
    for (int i = 0; i < PRESET_COUNT; i++)
        if (strcmp(name, presets[i].name) == 0)
            return pp_room_variant_add(variant, presets[i].words, err);
    char *value = strchr(name, '=');
    if (!value)
        return pp_fail(err, PP_BAD_INPUT,
                       "\"%s\" is neither a switch nor a preset; expected a switch "
                       "such as bounces=2, or rtrace-defaults, low, medium or high",
                       name);
    *value++ = '\0';
    return read_switch(variant, name, value, err);
}

enum pp_status pp_room_variant_add(struct pp_room_variant *variant, const char *words,
                                   struct pp_error *err)
{
    enum pp_status status = PP_OK;
    for (const char *word = words; status == PP_OK; word++) {
        size_t length = strcspn(word, ",");
        status = add_word(variant, word, length, err);
        word += length;
        if (*word == '\0')
            break;
    }
    return status;
}
