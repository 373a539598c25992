/* picture_pfm.c - see picture_pfm.h. */
#include "model/pictures/picture_pfm.h"

#include <stdbool.h>
#include <stdint.h>
#include <string.h>

#include "model/base/text.h"

enum pp_status pp_picture_pfm_write(FILE *out, const struct pp_picture *picture,
                                    struct pp_error *err)
{
    fprintf(out, "PF\n%d %d\n-1.0\n", picture->width, picture->height);
    for (int y = picture->height - 1; y >= 0; y--)
        for (int i = 0; i < 3 * picture->width; i++) {
            uint32_t bits;
            memcpy(&bits, pp_picture_at(picture, 0, y) + i, sizeof bits);
            for (int byte = 0; byte < 4; byte++)
                putc((int)(bits >> 8 * byte & 255), out);
        }
    if (ferror(out))
        return pp_fail(err, PP_SYSTEM, "the picture cannot be written");
    return PP_OK;
}

/* Reads the next word of the header and moves *at to its end. Returns false if there is
 * no word, or no white space after it. */
static bool read_word(char word[32], const unsigned char *bytes, size_t length,
                      size_t *at)
{
    while (*at < length && pp_text_is_white((char)bytes[*at]))
        (*at)++;
    size_t count = 0;
    while (*at < length && count < 31 && !pp_text_is_white((char)bytes[*at]))
        word[count++] = (char)bytes[(*at)++];
    word[count] = '\0';
    return count > 0 && *at < length && pp_text_is_white((char)bytes[*at]);
}

static bool read_length(const char *word, int *value)
{
    double number;
    if (!pp_text_parse_number(word, &number) || !(number >= 1.0) || !(number <= 1e6))
        return false;
    *value = (int)number;
    return (double)*value == number;
}

static float float_at(const unsigned char *bytes, bool least_first)
{
    uint32_t bits = 0;
    for (int i = 0; i < 4; i++)
        bits |= (uint32_t)bytes[i] << 8 * (least_first ? i : 3 - i);
    float value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

enum pp_status pp_picture_pfm_read(struct pp_picture *picture,
                                   const unsigned char *bytes, size_t length,
                                   struct pp_error *err)
{
    char kind[32], across[32], down[32], order[32];
    size_t at = 0;
    int width, height;
    double scale;
    *picture = (struct pp_picture){0};
    if (!read_word(kind, bytes, length, &at)
        || (strcmp(kind, "PF") != 0 && strcmp(kind, "Pf") != 0))
        return pp_fail(err, PP_BAD_INPUT,
                       "line 1: not a portable float map; expected \"PF\" or \"Pf\"");
    if (!read_word(across, bytes, length, &at) || !read_word(down, bytes, length, &at)
        || !read_length(across, &width) || !read_length(down, &height))
        return pp_fail(err, PP_BAD_INPUT, "line 2: no size; expected width and height");
    if (!read_word(order, bytes, length, &at) || !pp_text_parse_number(order, &scale)
        || scale == 0.0)
        return pp_fail(err, PP_BAD_INPUT,
                       "line 3: no byte order; expected -1.0 or 1.0");
    at++; /* the single white byte after the header */
    size_t channels = kind[1] == 'F' ? 3 : 1;
    if ((length - at) / (4 * channels) / (size_t)width < (size_t)height)
        return pp_fail(err, PP_BAD_INPUT,
                       "the picture is cut off: %zu bytes for %d rows of %d pixels",
                       length - at, height, width);
    enum pp_status status = pp_picture_init(picture, width, height, err);
    for (int y = height - 1; y >= 0 && status == PP_OK; y--)
        for (int x = 0; x < width; x++, at += 4 * channels)
            for (size_t i = 0; i < 3; i++)
                pp_picture_at(picture, x, y)[i] =
                    float_at(bytes + at + (channels == 3 ? 4 * i : 0), scale < 0.0);
    return status;
}
