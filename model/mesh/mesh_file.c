/* mesh_file.c - see mesh_file.h. */
#include "model/mesh/mesh_file.h"

#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "model/base/read_file.h"
#include "model/mesh/mesh_dxf.h"
#include "model/mesh/mesh_obj.h"

static bool ends_with(const char *name, const char *end)
{
    size_t length = strlen(name), tail = strlen(end);
    return length > tail && strcasecmp(name + length - tail, end) == 0;
}

static enum pp_status fail_kind(const char *name, struct pp_error *err)
{
    return pp_fail(err, PP_BAD_INPUT,
                   "%.200s: the file type is unknown; expected .obj or .dxf", name);
}

enum pp_status pp_mesh_file_parse(struct pp_mesh_triangles *mesh, char *bytes,
                                  size_t length, const char *name, struct pp_error *err)
{
    struct pp_mesh_lines lines = {.text = bytes, .left = length, .file = name};
    if (length >= 3 && memcmp(bytes, "\xef\xbb\xbf", 3) == 0) /* byte order mark */
        lines.text += 3, lines.left -= 3;
    if (ends_with(name, ".obj"))
        return pp_mesh_obj_read(mesh, &lines, err);
    if (ends_with(name, ".dxf"))
        return pp_mesh_dxf_read(mesh, &lines, err);
    return fail_kind(name, err);
}

enum pp_status pp_mesh_file_read(struct pp_mesh_triangles *mesh, const char *path,
                                 struct pp_error *err)
{
    char *bytes;
    size_t length;
    if (!ends_with(path, ".obj") && !ends_with(path, ".dxf"))
        return fail_kind(path, err);
    enum pp_status status =
        pp_read_file_regular(&bytes, &length, path, PP_MESH_FILE_BYTES_MOST, err);
    if (status != PP_OK)
        return status;
    if (length > PP_MESH_FILE_BYTES_MOST)
        status =
            pp_fail(err, PP_BAD_INPUT,
                    "%.200s: the file is larger than %d MB; expected a coarser model",
                    path, PP_MESH_FILE_BYTES_MOST >> 20);
    else
        status = pp_mesh_file_parse(mesh, bytes, length, path, err);
    free(bytes);
    return status;
}
