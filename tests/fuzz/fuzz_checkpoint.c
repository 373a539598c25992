/* fuzz_checkpoint.c - a checkpoint with any bytes is read safely.
 *
 * For clang's libFuzzer (make fuzz). A file is rejected with a reason and does not
 * change the picture; or it is accepted, would be written again identically, and the
 * picture is completed from it. In half of the files header and checksum are corrected
 * first; otherwise nearly all would be rejected there.
 */
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "simulate/render/checkpoint.h"
#include "simulate/sampling/hash.h"
#include "simulate/render/render.h"
#include "simulate/scene/light_scene_of_description.h"
#include "tests/fuzz/floor_scene.h"
#include "tests/fuzz/must.h"

/* Bytes of the header with its counts, as written by checkpoint.c, and of the checksum
 * at the end. */
enum { MARKED = 8 + 4 + 8 + 3 * 4, TAIL = 8 };

/* A picture of 2 by 2 tiles, the right and lower ones narrower. */
static struct pp_render *fresh_render(void)
{
    struct pp_render_options options = {.width = 17,
                                        .height = 18,
                                        .samples = 1,
                                        .light = pp_radiance_state_defaults(),
                                        .threads = 1};
    struct pp_render *render = NULL;
    must(pp_camera_set(&options.camera, PP_VIEW_PARALLEL, pp_vec(1.0, 1.0, 1.0),
                       pp_vec(0.0, 0.0, -1.0), pp_vec(0.0, 1.0, 0.0), 1.0, 1.0, NULL)
         == PP_OK);
    must(pp_render_create(&render, floor_scene(), NULL, &options, NULL) == PP_OK);
    return render;
}

static unsigned char *saved(const struct pp_render *render, size_t *length)
{
    char *bytes = NULL;
    FILE *out = open_memstream(&bytes, length);
    must(out && pp_checkpoint_save(render, NULL, out, NULL) == PP_OK
         && fclose(out) == 0);
    return (unsigned char *)bytes;
}

static void put_right(unsigned char *bytes, size_t length, const unsigned char *head)
{
    if (length < MARKED + TAIL)
        return;
    memcpy(bytes, head, MARKED);
    size_t summed = length - TAIL;
    uint64_t sum = pp_hash(2, summed);
    for (size_t i = 0; i < summed; i += 8) {
        uint64_t word = 0;
        memcpy(&word, bytes + i, summed - i < 8 ? summed - i : 8);
        sum = pp_hash(sum, word);
    }
    for (int i = 0; i < TAIL; i++)
        bytes[summed + (size_t)i] = (unsigned char)(sum >> 8 * i);
}

int LLVMFuzzerTestOneInput(const uint8_t *given, size_t length)
{
    struct pp_error err = {PP_OK, ""};
    struct pp_render *render = fresh_render();
    size_t own_length;
    unsigned char *own = saved(render, &own_length), *bytes = malloc(length + 1);
    must(bytes);
    memcpy(bytes, given, length);
    if (length > 0 && given[length - 1] & 1)
        put_right(bytes, length, own);
    free(own);
    enum pp_status status = pp_checkpoint_resume(render, bytes, length, &err);
    if (status == PP_OK) {
        const char *cache;
        size_t kept;
        must(pp_checkpoint_cache(bytes, length, &cache, &kept, NULL) == PP_OK);
        own = saved(render, &own_length);
        must(own_length + kept == length);
        must(kept > 0 || memcmp(own, bytes, length) == 0);
        free(own);
        pp_render_advance(render, 10.0, NULL);
        must(pp_render_done(render));
    } else {
        must(err.message[0] != '\0' && pp_render_progress(render) == 0.0);
    }
    free(bytes);
    pp_render_destroy(render);
    return 0;
}
