/* fuzz_mesh.c - an OBJ or DXF file with any bytes is read safely.
 *
 * For clang's libFuzzer (make fuzz). The sanitizers report errors. A file must also be
 * rejected with a reason, or the corners of its triangles must exist and have finite
 * coordinates. The first byte selects the format.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "model/mesh/mesh_file.h"
#include "tests/fuzz/must.h"

static void check(const struct pp_mesh_triangles *mesh)
{
    for (int i = 0; i < mesh->corner_count; i++)
        must(isfinite(mesh->corners[i].x) && isfinite(mesh->corners[i].y)
             && isfinite(mesh->corners[i].z));
    for (int i = 0; i < mesh->triangle_count; i++)
        for (int k = 0; k < 3; k++)
            must(mesh->triangles[i][k] >= 0
                 && mesh->triangles[i][k] < mesh->corner_count);
    must(isfinite(mesh->unit_m) && mesh->unit_m >= 0.0);
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t length)
{
    if (length == 0)
        return 0;
    struct pp_mesh_triangles mesh = {0};
    struct pp_error err = {PP_OK, ""};
    char *text = malloc(length);
    if (!text)
        return 0;
    memcpy(text, bytes + 1, length - 1);
    text[length - 1] = '\0';
    enum pp_status status = pp_mesh_file_parse(
        &mesh, text, length - 1, bytes[0] == 'o' ? "fuzz.obj" : "fuzz.dxf", &err);
    must(status == PP_OK || err.message[0] != '\0');
    if (status == PP_OK)
        check(&mesh);
    pp_mesh_triangles_clear(&mesh);
    free(text);
    return 0;
}
