/* fuzz_rad.c - whatever bytes a Radiance scene holds, reading it ends well, and what
 * was read can be written and read back.
 *
 * For clang's libFuzzer (make fuzz). The sanitizers say what is wrong; besides, a scene
 * is refused with a reason that has file and line, or taken; then its shapes name
 * materials that there are, and as many come back. A file that a line names is the
 * second half of the fuzzer's bytes: linked with --wrap=pp_read_file, nothing else is
 * read. It may name itself.
 */
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "formats/radiance/read/rad_read.h"
#include "formats/radiance/write/rad_write.h"
#include "formats/radiance/write/rad_write_materials.h"
#include "tests/fuzz/must.h"

enum pp_status __wrap_pp_file_bytes(char **bytes, size_t *length, const char *path,
                                    size_t most, struct pp_error *err);

static const uint8_t *fuzzed;
static size_t fuzzed_length;

enum pp_status __wrap_pp_file_bytes(char **bytes, size_t *length, const char *path,
                                    size_t most, struct pp_error *err)
{
    (void)path, (void)most;
    size_t half = fuzzed_length / 2;
    *length = fuzzed_length - half;
    *bytes = malloc(*length + 1);
    if (!*bytes)
        return pp_fail_memory(err);
    memcpy(*bytes, fuzzed + half, *length);
    return PP_OK;
}

static void write_and_read(const struct pp_scene_description *scene)
{
    struct pp_error err = {PP_OK, ""};
    struct pp_rad_writer *writer;
    if (pp_rad_write_create(&writer, scene, &err) != PP_OK) {
        must(err.message[0] != '\0');
        return;
    }
    char *text = NULL;
    size_t length = 0;
    FILE *out = open_memstream(&text, &length);
    must(out != NULL);
    pp_rad_write_materials(writer, out);
    pp_rad_write_shapes(writer, "s", 0, scene->shape_count, out);
    fclose(out);
    pp_rad_write_destroy(writer);
    struct pp_scene_description back;
    struct pp_rad_summary summary;
    enum pp_status status =
        pp_rad_read_bytes(&back, &summary, text, length, "back.rad", &err);
    must(status == PP_OK || err.message[0] != '\0');
    if (status == PP_OK)
        must(back.shape_count + summary.flat >= scene->shape_count);
    pp_scene_description_clear(&back);
    free(text);
}

/* "FILE:LINE: " and more. */
static bool has_line(const char *message)
{
    for (const char *at = strchr(message, ':'); at; at = strchr(at + 1, ':')) {
        size_t digits = strspn(at + 1, "0123456789");
        if (digits > 0 && at[1 + digits] == ':' && at[2 + digits] == ' ')
            return true;
    }
    return false;
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t length)
{
    struct pp_error err = {PP_OK, ""};
    struct pp_scene_description scene;
    struct pp_rad_summary summary;
    fuzzed = bytes;
    fuzzed_length = length;
    enum pp_status status = pp_rad_read_bytes(&scene, &summary, (const char *)bytes,
                                              length, "fuzz.rad", &err);
    must(status == PP_OK || err.message[0] != '\0');
    must(status != PP_BAD_INPUT || has_line(err.message));
    for (int i = 0; i < scene.shape_count; i++)
        must(scene.shapes[i].material >= 0
             && scene.shapes[i].material < scene.material_count
             && scene.shapes[i].back_material < scene.material_count);
    if (status == PP_OK)
        write_and_read(&scene);
    pp_scene_description_clear(&scene);
    return 0;
}
