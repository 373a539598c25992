/* picture_pfm.c - see picture_pfm.h. */
#include "formats/pictures/picture_pfm.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

#include "formats/pictures/number_format.h"

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
        return pp_fail(err, PP_SYSTEM, "the picture can't be written");
    return PP_OK;
}

/* Copy in which NaN is black, as other programs expect. */
static enum pp_status without_gaps(struct pp_picture *copy,
                                   const struct pp_picture *picture,
                                   struct pp_error *err)
{
    enum pp_status status = pp_picture_init(copy, picture->width, picture->height, err);
    if (status != PP_OK)
        return status;
    size_t count = 3 * (size_t)picture->width * (size_t)picture->height;
    for (size_t i = 0; i < count; i++)
        copy->rgb[i] = isfinite(picture->rgb[i]) ? picture->rgb[i] : 0.0f;
    return PP_OK;
}

static enum pp_status write_whole(FILE *out, const struct pp_picture *picture,
                                  const struct pp_hdr_notes *notes,
                                  struct pp_error *err)
{
    (void)notes;
    struct pp_picture whole;
    enum pp_status status = without_gaps(&whole, picture, err);
    if (status != PP_OK)
        return status;
    status = pp_picture_pfm_write(out, &whole, err);
    pp_picture_clear(&whole);
    return status;
}

const struct pp_number_format pp_number_format_pfm = {
    .ending = "pfm",
    .summary = "portable float map, to the last digit of a float",
    .write = write_whole,
};
