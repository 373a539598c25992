/* epw_records.h - the records of a weather file, in their order. Inside formats/epw/
 * only. */
#ifndef PP_FORMATS_EPW_EPW_RECORDS_H
#define PP_FORMATS_EPW_EPW_RECORDS_H

#include "formats/epw/epw_header.h"

/* Reads the records into epw, from `record` on. PP_OK also where there are mistakes. */
enum pp_status pp_epw_records_read(struct pp_epw *epw,
                                   const struct pp_epw_header *header,
                                   struct pp_epw_lines *lines, char *record,
                                   struct pp_mistakes *mistakes, struct pp_error *err);

#endif
