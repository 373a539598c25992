/* number_format.c - the list of formats that store a picture's numbers. */
#include "formats/pictures/number_format.h"

#include <math.h>
#include <stddef.h>
#include <strings.h>

#include "model/pictures/picture_pfm.h"

const struct pp_number_format pp_number_format_hdr = {
    .extension = "hdr",
    .other_extension = "pic",
    .summary = "Radiance format, accurate to 1 % of the brightest channel, with notes "
               "in the header",
    .write = pp_picture_hdr_write,
};

/* A copy with 0 for each channel that is NaN or infinite, as other programs expect. */
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
    .extension = "pfm",
    .summary = "portable float map, accurate to the last digit of a float",
    .write = write_whole,
};

static const struct pp_number_format *const formats[] = {
    &pp_number_format_hdr,
    &pp_number_format_pfm,
    NULL,
};

const struct pp_number_format *pp_number_format_at(int index)
{
    return formats[index];
}

const struct pp_number_format *pp_number_format_find(const char *extension)
{
    for (int i = 0; formats[i]; i++)
        if (strcasecmp(formats[i]->extension, extension) == 0
            || (formats[i]->other_extension
                && strcasecmp(formats[i]->other_extension, extension) == 0))
            return formats[i];
    return NULL;
}
