/* bsdf_file.h - reads the scattering data of a glazing system from a WINDOW XML file,
 * as written by WINDOW, genBSDF and pabopto2bsdf.
 *
 * The file describes blocks of BSDF values, 1/sr, for several bands of wavelength; only
 * the band "Visible" is read. Supported layouts are matrices over Klems's bases or over
 * bases that the file defines by rings, and tensor trees (tensor_tree.h). Numbers are
 * separated by blanks or commas. Negative values count as 0.
 */
#ifndef PP_MODEL_LIGHT_BSDF_BSDF_FILE_H
#define PP_MODEL_LIGHT_BSDF_BSDF_FILE_H

#include <stddef.h>

#include "model/light/bsdf/bsdf.h"

/* Limit on the bytes of a file. */
enum { PP_BSDF_FILE_BYTES_MOST = 64 << 20 };

/* Reads the file, and completes the data (pp_bsdf_complete). PP_BAD_INPUT names file
 * and line. On success the caller clears *bsdf. */
enum pp_status pp_bsdf_file_read(struct pp_bsdf *bsdf, const char *path,
                                 struct pp_error *err);

/* Reads from memory; the bytes are changed. name: name of the file, for messages. */
enum pp_status pp_bsdf_file_parse(struct pp_bsdf *bsdf, char *bytes, size_t length,
                                  const char *name, struct pp_error *err);

#endif
