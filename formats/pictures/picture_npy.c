/* picture_npy.c - NumPy's array file, version 1.0, as its Enhancement Proposal 1 ("A
 * simple file format for NumPy arrays", Kern 2007) has it:
 *
 *     "\x93NUMPY", 1, 0      magic and version
 *     two bytes              length of what follows up to the data, lowest first
 *     a Python dictionary    element type, order, shape; filled up with spaces and
 *                            ended by a newline, so that the data begin at a multiple
 *                            of 64 bytes
 *     the data
 *
 * The array is (height, width, 3) of '<f4': rows from the top, red, green and blue, the
 * picture's floats as they are; what is no number stays NaN. It has no place for notes.
 */
#include <stdint.h>
#include <string.h>

#include "formats/pictures/number_format.h"

enum { ALIGNED = 64, LEAD = 10 /* bytes before the dictionary */ };

static void write_head(FILE *out, const struct pp_picture *picture)
{
    char head[2 * ALIGNED];
    int length = snprintf(head, sizeof head,
                          "{'descr': '<f4', 'fortran_order': False, "
                          "'shape': (%d, %d, 3), }",
                          picture->height, picture->width);
    int whole = (LEAD + length + 1 + ALIGNED - 1) / ALIGNED * ALIGNED;
    int rest = whole - LEAD;
    fwrite("\x93NUMPY\1\0", 1, 8, out);
    putc(rest & 255, out);
    putc(rest >> 8, out);
    fprintf(out, "%-*s\n", rest - 1, head);
}

static enum pp_status write_npy(FILE *out, const struct pp_picture *picture,
                                const struct pp_hdr_notes *notes, struct pp_error *err)
{
    (void)notes;
    write_head(out, picture);
    size_t count = 3 * (size_t)picture->width * (size_t)picture->height;
    for (size_t i = 0; i < count; i++) {
        uint32_t bits;
        memcpy(&bits, picture->rgb + i, sizeof bits);
        for (int byte = 0; byte < 4; byte++)
            putc((int)(bits >> 8 * byte & 255), out);
    }
    if (ferror(out))
        return pp_fail(err, PP_SYSTEM, "the picture can't be written");
    return PP_OK;
}

const struct pp_number_format pp_number_format_npy = {
    .ending = "npy",
    .summary = "NumPy's array, to the last digit of a float",
    .write = write_npy,
};
