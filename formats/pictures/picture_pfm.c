/* picture_pfm.c - see picture_pfm.h. */
#include "formats/pictures/picture_pfm.h"

#include <stdint.h>
#include <string.h>

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
