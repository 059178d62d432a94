/* data_file.h - #fopen, #read, #write, #fclose: values from files.
 *
 * A file is found as those of #include are, and read value by value: floats,
 * vectors, strings, with commas between them or without.  Behind the last one
 * its name is forgotten, as in POV-Ray, so that `defined` tells the end.  A
 * scene that is read writes no file: what it gives to #write is left out.
 */
#ifndef RT_SCENE_DATA_FILE_H
#define RT_SCENE_DATA_FILE_H

#include "rt/scene/language/block.h"

item_reader data_file_open, data_file_read, data_file_write, data_file_close;

#endif
