/* gbxml_read.h - reads the parts of a gbXML document that matter for daylight. Inside
 * formats/gbxml/ only. */
#ifndef PP_FORMATS_GBXML_GBXML_READ_H
#define PP_FORMATS_GBXML_GBXML_READ_H

#include "formats/gbxml/gbxml_document.h"
#include "formats/gbxml/gbxml_model.h"

/* Fills the model. Missing data, with the default used, and skipped parts are noted by
 * line. PP_BAD_INPUT if the file has no known length unit, no Campus or no Space, or
 * exceeds a limit. The model can be cleared even after a failure. */
enum pp_status pp_gbxml_read(struct pp_gbxml_model *model,
                             const struct pp_xml *document, const char *file,
                             struct pp_mistakes *notes, struct pp_error *err);

#endif
