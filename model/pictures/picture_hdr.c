/* picture_hdr.c - see picture_hdr.h. */
#include "model/pictures/picture_hdr.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/text.h"

/* PACKED_LEAST, PACKED_MOST: widths whose rows may be run-length encoded by channel.
 * The format has 15 bits for the width, and shorter rows could be mistaken for
 * pixels. */
enum { PACKED_LEAST = 8, PACKED_MOST = 32767, RUN_LEAST = 4, RUN_MOST = 127 };

enum { LINE_MOST = 2048 };

/* ---- pixels ---- */

static void to_rgbe(unsigned char rgbe[4], const float rgb[3])
{
    double most = 0.0;
    bool finite = true;
    for (int i = 0; i < 3; i++) {
        finite = finite && isfinite(rgb[i]);
        most = rgb[i] > most ? rgb[i] : most;
    }
    int exponent;
    double mantissa = frexp(finite ? most : 0.0, &exponent);
    memset(rgbe, 0, 4);
    if (mantissa == 0.0 || exponent < -127)
        return;
    if (exponent > 127) { /* 2^127 and above: the brightest possible pixel */
        memset(rgbe, 255, 4);
        return;
    }
    for (int i = 0; i < 3; i++)
        if (rgb[i] > 0.0f)
            rgbe[i] = (unsigned char)ldexp(rgb[i], 8 - exponent);
    rgbe[3] = (unsigned char)(exponent + 128);
}

/* Converts to floats; each is the middle of its quantisation step. */
static void from_rgbe(float rgb[3], const unsigned char rgbe[4])
{
    for (int i = 0; i < 3; i++)
        rgb[i] =
            rgbe[3] == 0 ? 0.0f : (float)ldexp(rgbe[i] + 0.5, (int)rgbe[3] - (128 + 8));
}

/* ---- writing ---- */

/* Length of the run of equal bytes that begins at `at`; bytes of a channel are 4
 * apart. */
static int run_at(const unsigned char *row, int at, int width)
{
    int run = 1;
    while (at + run < width && run < RUN_MOST && row[4 * (at + run)] == row[4 * at])
        run++;
    return run;
}

/* Writes one channel of a row: runs of equal bytes, and other bytes unchanged. */
static void write_channel(FILE *out, const unsigned char *row, int width)
{
    for (int at = 0; at < width;) {
        int begin = at, run = run_at(row, at, width);
        while (run < RUN_LEAST && at - begin + run <= 128 && at + run < width) {
            at += run;
            run = run_at(row, at, width);
        }
        if (run < RUN_LEAST && at - begin + run <= 128) { /* last run of the row */
            at += run;
            run = 0;
        }
        if (at > begin) {
            putc(at - begin, out);
            for (int i = begin; i < at; i++)
                putc(row[4 * i], out);
        }
        if (run >= RUN_LEAST) {
            putc(128 + run, out);
            putc(row[4 * at], out);
            at += run;
        }
    }
}

static void write_row(FILE *out, const unsigned char *row, int width)
{
    if (width < PACKED_LEAST || width > PACKED_MOST) {
        fwrite(row, 4, (size_t)width, out);
        return;
    }
    const unsigned char head[4] = {2, 2, (unsigned char)(width >> 8),
                                   (unsigned char)(width & 255)};
    fwrite(head, 4, 1, out);
    for (int channel = 0; channel < 4; channel++)
        write_channel(out, row + channel, width);
}

enum pp_status pp_picture_hdr_write(FILE *out, const struct pp_picture *picture,
                                    const struct pp_hdr_notes *notes,
                                    struct pp_error *err)
{
    unsigned char *row = malloc(4 * (size_t)picture->width);
    if (!row)
        return pp_fail_memory(err);
    fputs("#?RADIANCE\n", out);
    if (notes && notes->software)
        fprintf(out, "SOFTWARE= %s\n", notes->software);
    if (notes && notes->view[0])
        fprintf(out, "VIEW= %s\n", notes->view);
    if (notes && notes->quantity[0])
        fprintf(out, "QUANTITY= %s\n", notes->quantity);
    double exposure = notes && notes->exposure > 0.0 ? notes->exposure : 1.0;
    fprintf(out, "EXPOSURE= %.9e\n", exposure);
    fprintf(out, "FORMAT=32-bit_rle_rgbe\n\n-Y %d +X %d\n", picture->height,
            picture->width);
    for (int y = 0; y < picture->height; y++) {
        for (int x = 0; x < picture->width; x++)
            to_rgbe(row + 4 * x, pp_picture_at(picture, x, y));
        write_row(out, row, picture->width);
    }
    free(row);
    if (ferror(out))
        return pp_fail(err, PP_SYSTEM, "the picture cannot be written");
    return PP_OK;
}

/* ---- reading the header ---- */

struct input {
    const unsigned char *bytes;
    size_t length, at;
    int line; /* number of the line read last, from 1 */
};

/* Reads the next line without its end. Returns false if the input ends before the line
 * does, or if the line is too long. */
static bool read_hdr_line(struct input *in, char line[LINE_MOST])
{
    size_t left = in->length - in->at;
    const unsigned char *from = in->bytes + in->at;
    const unsigned char *end = left ? memchr(from, '\n', left) : NULL;
    if (!end || end - from >= LINE_MOST)
        return false;
    size_t count = (size_t)(end - from);
    in->at += count + 1;
    in->line++;
    if (count > 0 && from[count - 1] == '\r')
        count--;
    memcpy(line, from, count);
    line[count] = '\0';
    return true;
}

/* Text after the word and "="; NULL if the line begins otherwise. */
static const char *behind(const char *line, const char *word)
{
    size_t length = strlen(word);
    if (strncmp(line, word, length) != 0 || line[length] != '=')
        return NULL;
    line += length + 1;
    return line + strspn(line, " \t");
}

static enum pp_status take_header_line(const struct input *in, const char *line,
                                       struct pp_hdr_notes *notes, struct pp_error *err)
{
    const char *value;
    if ((value = behind(line, "FORMAT"))) {
        if (strcmp(value, "32-bit_rle_rgbe") != 0)
            return pp_fail(err, PP_BAD_INPUT,
                           "line %d: the format is \"%.60s\"; expected 32-bit_rle_rgbe",
                           in->line, value);
    } else if ((value = behind(line, "EXPOSURE"))) {
        double exposure;
        if (!pp_text_parse_number(value, &exposure) || !(exposure > 0.0)
            || !isfinite(notes->exposure * exposure)
            || !(notes->exposure * exposure > 0.0))
            return pp_fail(err, PP_BAD_INPUT,
                           "line %d: the exposure is \"%.60s\"; expected a number "
                           "above 0",
                           in->line, value);
        notes->exposure *= exposure;
    } else if ((value = behind(line, "VIEW"))) {
        snprintf(notes->view, sizeof notes->view, "%.*s", PP_HDR_VIEW_SIZE - 1, value);
    } else if ((value = behind(line, "QUANTITY"))) {
        snprintf(notes->quantity, sizeof notes->quantity, "%.*s",
                 (int)sizeof notes->quantity - 1, value);
    }
    return PP_OK;
}

/* Reads "-Y 512 +X 768": lengths and directions. */
static bool read_size(const char *line, int size[2], char signs[2])
{
    char axes[2], rest;
    if (sscanf(line, "%c%c %6d %c%c %6d %c", &signs[0], &axes[0], &size[0], &signs[1],
               &axes[1], &size[1], &rest)
        != 6)
        return false;
    for (int i = 0; i < 2; i++)
        if ((signs[i] != '+' && signs[i] != '-') || size[i] < 1)
            return false;
    return axes[0] == 'Y' && axes[1] == 'X';
}

static enum pp_status read_header(struct input *in, struct pp_hdr_notes *notes,
                                  int size[2], char signs[2], struct pp_error *err)
{
    char line[LINE_MOST];
    if (!read_hdr_line(in, line) || strncmp(line, "#?", 2) != 0)
        return pp_fail(
            err, PP_BAD_INPUT,
            "line 1: this is not a Radiance picture; expected \"#?RADIANCE\"");
    for (;;) {
        if (!read_hdr_line(in, line))
            return pp_fail(err, PP_BAD_INPUT,
                           "line %d: the header is incomplete, or one of its lines has "
                           "more than %d characters",
                           in->line + 1, LINE_MOST);
        if (line[0] == '\0')
            break;
        enum pp_status status = take_header_line(in, line, notes, err);
        if (status != PP_OK)
            return status;
    }
    if (!read_hdr_line(in, line) || !read_size(line, size, signs))
        return pp_fail(
            err, PP_BAD_INPUT,
            "line %d: the size is missing; expected a size such as \"-Y 480 +X 640\"",
            in->line);
    return PP_OK;
}

/* ---- reading the pixels ---- */

/* Reads a row of pixels; each is explicit or repeats the previous one. */
static bool read_plain_row(struct input *in, unsigned char *row, int width)
{
    int shift = 0;
    for (int x = 0; x < width;) {
        if (in->length - in->at < 4)
            return false;
        const unsigned char *pixel = in->bytes + in->at;
        in->at += 4;
        if (pixel[0] != 1 || pixel[1] != 1 || pixel[2] != 1) {
            memcpy(row + 4 * x++, pixel, 4);
            shift = 0;
            continue;
        }
        long again = (long)pixel[3] << shift;
        if (x == 0 || shift > 16 || again > width - x)
            return false;
        for (; again > 0; again--, x++)
            memcpy(row + 4 * x, row + 4 * (x - 1), 4);
        shift += 8;
    }
    return true;
}

/* Reads a run-length encoded row, by channel. */
static bool read_packed_row(struct input *in, unsigned char *row, int width)
{
    for (int channel = 0; channel < 4; channel++)
        for (int x = 0; x < width;) {
            if (in->length - in->at < 2)
                return false;
            int count = in->bytes[in->at++];
            bool run = count > 128;
            count -= run ? 128 : 0;
            if (count == 0 || count > width - x
                || (size_t)(run ? 1 : count) > in->length - in->at)
                return false;
            for (int i = 0; i < count; i++, x++)
                row[4 * x + channel] = in->bytes[in->at + (size_t)(run ? 0 : i)];
            in->at += (size_t)(run ? 1 : count);
        }
    return true;
}

static bool read_hdr_row(struct input *in, unsigned char *row, int width)
{
    if (in->length - in->at < 4)
        return false;
    const unsigned char *head = in->bytes + in->at;
    bool packed = width >= PACKED_LEAST && width <= PACKED_MOST && head[0] == 2
                  && head[1] == 2 && !(head[2] & 128);
    if (!packed)
        return read_plain_row(in, row, width);
    if ((head[2] << 8 | head[3]) != width)
        return false;
    in->at += 4;
    return read_packed_row(in, row, width);
}

enum pp_status pp_picture_hdr_read(struct pp_picture *picture,
                                   struct pp_hdr_notes *notes,
                                   const unsigned char *bytes, size_t length,
                                   struct pp_error *err)
{
    *picture = (struct pp_picture){0};
    *notes = (struct pp_hdr_notes){.exposure = 1.0};
    struct input in = {bytes, length, 0, 0};
    int size[2];
    char signs[2];
    enum pp_status status = read_header(&in, notes, size, signs, err);
    /* A row needs at least four bytes, so that a short file cannot request much
     * memory. */
    if (status == PP_OK && (length - in.at) / 4 < (size_t)size[0])
        status =
            pp_fail(err, PP_BAD_INPUT, "the picture is cut off: %zu bytes for %d rows",
                    length - in.at, size[0]);
    if (status == PP_OK)
        status = pp_picture_init(picture, size[1], size[0], err);
    if (status != PP_OK)
        return status;

    unsigned char *row = malloc(4 * (size_t)size[1]);
    if (!row)
        status = pp_fail_memory(err);
    for (int i = 0; i < size[0] && status == PP_OK; i++) {
        if (!read_hdr_row(&in, row, size[1])) {
            status = pp_fail(err, PP_BAD_INPUT, "row %d of %d is cut off or invalid",
                             i + 1, size[0]);
            break;
        }
        int y = signs[0] == '-' ? i : size[0] - 1 - i;
        for (int k = 0; k < size[1]; k++)
            from_rgbe(pp_picture_at(picture, signs[1] == '+' ? k : size[1] - 1 - k, y),
                      row + 4 * k);
    }
    free(row);
    if (status != PP_OK)
        pp_picture_clear(picture);
    return status;
}
