/* png_bands.c - draws band by band, and packs the rows into one stream [RFC1950], a piece
 * a band. */
#include "charts/sheet/png_bands.h"

#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>

/* ---- the packed stream ---- */

struct packed_stream {
    struct pp_bytes out; /* of the piece so far */
    uint32_t bits;       /* that make no whole byte yet, the first lowest */
    int bit_count;
    uint32_t sums[2]; /* of all bytes, modulo 65521: the stream's check */
    int last;         /* the byte before, -1: none; then how often it has come again */
    unsigned run;
    bool failed;
};

static void put_bits(struct packed_stream *stream, uint32_t bits, int count)
{
    stream->bits |= bits << stream->bit_count;
    stream->bit_count += count;
    for (; stream->bit_count >= 8; stream->bit_count -= 8, stream->bits >>= 8) {
        unsigned char byte = (unsigned char)stream->bits;
        if (!pp_bytes_add(&stream->out, &byte, 1))
            stream->failed = true;
    }
}

/* Codes begin with their highest bit. */
static void put_code(struct packed_stream *stream, unsigned code, int count)
{
    unsigned turned = 0;
    for (int i = 0; i < count; i++)
        turned |= (code >> i & 1) << (count - 1 - i);
    put_bits(stream, turned, count);
}

/* The fixed code of a byte (to 255), the end (256) or a length (from 257). */
static void put_symbol(struct packed_stream *stream, unsigned symbol)
{
    if (symbol < 144)
        put_code(stream, 0x30 + symbol, 8);
    else if (symbol < 256)
        put_code(stream, 0x190 + symbol - 144, 9);
    else if (symbol < 280)
        put_code(stream, symbol - 256, 7);
    else
        put_code(stream, 0xC0 + symbol - 280, 8);
}

enum { RUN_LEAST = 3, RUN_MOST = 258, LENGTHS = 29 };

/* The last byte again, `length` times: RUN_LEAST to RUN_MOST. */
static void put_run(struct packed_stream *stream, unsigned length)
{
    static const unsigned short least[LENGTHS] = {
        3,  4,  5,  6,  7,  8,  9,  10, 11,  13,  15,  17,  19,  23, 27,
        31, 35, 43, 51, 59, 67, 83, 99, 115, 131, 163, 195, 227, 258};
    int of = LENGTHS - 1;
    while (least[of] > length)
        of--;
    put_symbol(stream, 257 + (unsigned)of);
    int more = of < 8 || of == LENGTHS - 1 ? 0 : of / 4 - 1;
    put_bits(stream, length - least[of], more);
    put_code(stream, 0, 5); /* a distance of one byte */
}

static void end_run(struct packed_stream *stream)
{
    if (stream->run >= RUN_LEAST)
        put_run(stream, stream->run);
    else
        for (unsigned i = 0; i < stream->run; i++)
            put_symbol(stream, (unsigned)stream->last);
    stream->run = 0;
}

static void begin_stream(struct packed_stream *stream)
{
    *stream = (struct packed_stream){.sums = {1, 0}, .last = -1};
    put_bits(stream, 0x78, 8);
    put_bits(stream, 0x01, 8);
    put_bits(stream, 1, 1); /* the last block, and the only one, */
    put_bits(stream, 1, 2); /* of fixed codes */
}

static void pack(struct packed_stream *stream, const unsigned char *bytes, size_t count)
{
    enum { UNTIL_MODULO = 5552 }; /* sums of so many bytes fit into 32 bits */
    for (size_t i = 0; i < count; i++) {
        stream->sums[0] += bytes[i];
        stream->sums[1] += stream->sums[0];
        if (i % UNTIL_MODULO == UNTIL_MODULO - 1 || i + 1 == count)
            for (int k = 0; k < 2; k++)
                stream->sums[k] %= 65521;
        if (bytes[i] == stream->last && stream->run < RUN_MOST) {
            stream->run++;
            continue;
        }
        end_run(stream);
        if (bytes[i] == stream->last) {
            stream->run = 1;
        } else {
            stream->last = bytes[i];
            put_symbol(stream, bytes[i]);
        }
    }
}

static void end_stream(struct packed_stream *stream)
{
    end_run(stream);
    put_symbol(stream, 256);
    put_bits(stream, 0, (8 - stream->bit_count) % 8);
    for (int k = 1; k >= 0; k--) {
        put_bits(stream, stream->sums[k] >> 8, 8);
        put_bits(stream, stream->sums[k] & 0xFF, 8);
    }
}

/* ---- the picture ---- */

/* A row of the file: how it is told (2: less the row above), then red, green, blue. */
struct picture_rows {
    int width;
    unsigned char *row, *above;
};

static void pack_band(struct packed_stream *stream, struct picture_rows *rows,
                      cairo_surface_t *band, int count)
{
    cairo_surface_flush(band);
    const unsigned char *data = cairo_image_surface_get_data(band);
    size_t stride = (size_t)cairo_image_surface_get_stride(band);
    for (int y = 0; y < count; y++) {
        const uint32_t *pixels = (const uint32_t *)(const void *)(data + y * stride);
        unsigned char *to = rows->row, *above = rows->above;
        *to++ = 2;
        for (int x = 0; x < rows->width; x++)
            for (int shift = 16; shift >= 0; shift -= 8) {
                unsigned char value = (unsigned char)(pixels[x] >> shift);
                *to++ = (unsigned char)(value - *above);
                *above++ = value;
            }
        pack(stream, rows->row, 1 + 3 * (size_t)rows->width);
    }
}

static cairo_status_t draw_bands(struct pp_bytes *png, struct packed_stream *stream,
                                 struct picture_rows *rows, cairo_surface_t *drawing,
                                 cairo_surface_t *band, int height)
{
    int most = cairo_image_surface_get_height(band);
    for (int first = 0; first < height; first += most) {
        cairo_t *cr = cairo_create(band);
        cairo_set_source_surface(cr, drawing, 0, -first);
        cairo_paint(cr);
        cairo_status_t status = cairo_status(cr);
        cairo_destroy(cr);
        if (status != CAIRO_STATUS_SUCCESS)
            return status;
        pack_band(stream, rows, band, height - first < most ? height - first : most);
        if (first + most >= height)
            end_stream(stream);
        if (stream->failed
            || !pp_bytes_add_chunk(png, "IDAT", stream->out.list, stream->out.count))
            return CAIRO_STATUS_NO_MEMORY;
        stream->out.count = 0;
    }
    return CAIRO_STATUS_SUCCESS;
}

static bool add_head(struct pp_bytes *png, int width, int height)
{
    static const unsigned char signature[8] = {0x89, 'P',  'N', 'G',
                                               '\r', '\n', 26,  '\n'};
    const unsigned char head[13] = {
        0, 0, (unsigned char)(width >> 8),  (unsigned char)width,
        0, 0, (unsigned char)(height >> 8), (unsigned char)height,
        8, 2 /* red, green, blue of 8 bits */};
    return pp_bytes_add(png, signature, sizeof signature)
           && pp_bytes_add_chunk(png, "IHDR", head, sizeof head);
}

cairo_status_t pp_png_bands_write(struct pp_bytes *png, cairo_surface_t *drawing,
                                  int width, int height, int rows)
{
    struct packed_stream stream;
    struct picture_rows lines = {width, malloc(1 + 3 * (size_t)width),
                                 calloc(3, (size_t)width)};
    cairo_surface_t *band = cairo_image_surface_create(CAIRO_FORMAT_RGB24, width,
                                                       rows < height ? rows : height);
    cairo_status_t status = cairo_surface_status(band);
    begin_stream(&stream);
    if (status == CAIRO_STATUS_SUCCESS
        && (!lines.row || !lines.above || !add_head(png, width, height)))
        status = CAIRO_STATUS_NO_MEMORY;
    if (status == CAIRO_STATUS_SUCCESS)
        status = draw_bands(png, &stream, &lines, drawing, band, height);
    if (status == CAIRO_STATUS_SUCCESS && !pp_bytes_add_chunk(png, "IEND", NULL, 0))
        status = CAIRO_STATUS_NO_MEMORY;
    cairo_surface_destroy(band);
    pp_bytes_clear(&stream.out);
    free(lines.row);
    free(lines.above);
    return status;
}
