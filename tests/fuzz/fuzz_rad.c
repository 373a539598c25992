/* fuzz_rad.c - a Radiance scene with any bytes is read safely, and can be written and
 * read back.
 *
 * For clang's libFuzzer (make fuzz). The sanitizers report errors. A scene must also be
 * rejected with a reason that contains file and line, or accepted; then the materials
 * of its shapes exist, and the same number of shapes is read back. An included file is
 * the second half of the fuzzer's bytes: with --wrap=pp_read_file_regular no other file is
 * read. It may include itself.
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

enum pp_status __wrap_pp_read_file_regular(char **bytes, size_t *length,
                                           const char *path, size_t most,
                                           struct pp_error *err);

static const uint8_t *fuzzed;
static size_t fuzzed_length;

enum pp_status __wrap_pp_read_file_regular(char **bytes, size_t *length,
                                           const char *path, size_t most,
                                           struct pp_error *err)
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

/* True if the message begins with "FILE:LINE: ". */
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
