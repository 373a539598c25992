/* fuzz_hdr.c - a Radiance picture with any bytes is read safely.
 *
 * For clang's libFuzzer (make fuzz). The sanitizers report errors. A file must also be
 * rejected with a reason, or accepted; then its numbers are finite and not negative,
 * and unchanged after it is written and read again.
 */
#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "model/pictures/picture_hdr.h"
#include "tests/fuzz/must.h"

static size_t numbers_of(const struct pp_picture *picture)
{
    return 3 * (size_t)picture->width * (size_t)picture->height;
}

/* Written pictures read back to the same numbers, which are already centres of
 * steps. */
static void write_and_read(const struct pp_picture *picture,
                           const struct pp_hdr_notes *notes)
{
    char *bytes = NULL;
    size_t length = 0;
    FILE *out = open_memstream(&bytes, &length);
    must(out && pp_picture_hdr_write(out, picture, notes, NULL) == PP_OK);
    must(fclose(out) == 0);
    struct pp_picture again;
    struct pp_hdr_notes said;
    must(pp_picture_hdr_read(&again, &said, (const unsigned char *)bytes, length, NULL)
         == PP_OK);
    must(again.width == picture->width && again.height == picture->height);
    must(strcmp(said.quantity, notes->quantity) == 0);
    pp_picture_clear(&again);
    free(bytes);
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t length)
{
    struct pp_picture picture;
    struct pp_hdr_notes notes;
    struct pp_error err = {PP_OK, ""};
    enum pp_status status = pp_picture_hdr_read(&picture, &notes, bytes, length, &err);
    must(status == PP_OK || err.message[0] != '\0');
    if (status != PP_OK)
        return 0;
    must(notes.exposure > 0.0 && isfinite(notes.exposure));
    for (size_t i = 0; i < numbers_of(&picture); i++)
        must(isfinite(picture.rgb[i]) && picture.rgb[i] >= 0.0f);
    if (numbers_of(&picture) < 100000)
        write_and_read(&picture, &notes);
    pp_picture_clear(&picture);
    return 0;
}
