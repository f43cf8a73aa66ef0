// Draws S1, three spheres on a plane, a row at a time, and says how long that took and what came out.
//
// s1.c, the scene, was made by `fixcast bake s1.nff -o s1.c`: bring scenes of your own the same way. A display takes the rows where
// show_row() is called; its bytes are RGB565, high byte first, as ST7789 and ILI9341 want them.
#include <fixcast.h>

enum { WIDTH = 32, HEIGHT = 24 };

extern "C" {
extern const fc_scene s1;
extern const fc_camera s1_camera;
}

static int64_t memory[20];  // fc_frame_memory(&s1, NULL) says how many bytes
static uint8_t pixels[WIDTH * 2];
static uint16_t depth[WIDTH];
static uint32_t crc;

// Here a CRC-32 instead of a display.
static void show_row(const uint8_t *bytes, size_t count) {
  while (count-- > 0) {
    crc ^= *bytes++;
    for (uint8_t bit = 0; bit < 8; bit++) crc = (crc >> 1) ^ ((crc & 1) != 0 ? 0xedb88320UL : 0);
  }
}

static int draw() {
  fc_frame frame;
  fc_target row = fc_target();
  row.pixels = pixels;
  row.pitch_bytes = WIDTH * 2;
  row.format = FC_RGB565_BE;
  row.depth = depth;
  crc = 0xffffffffUL;
  int error = fc_frame_setup(&frame, &s1, &s1_camera, NULL, WIDTH, HEIGHT, memory, sizeof memory);
  for (uint16_t y = 0; error == FC_OK && y < HEIGHT; y++) {
    error = fc_render_rows(&frame, y, 1, &row);
    if (error == FC_OK) show_row(pixels, sizeof pixels);
  }
  return error;
}

void setup() {
  Serial.begin(115200);
  const unsigned long began = micros();
  const int error = draw();
  const unsigned long us = micros() - began;
  char line[48];
  if (error == FC_OK) {
    snprintf(line, sizeof line, "s1 %dx%d 0x%08lx", WIDTH, HEIGHT, (unsigned long)(crc ^ 0xffffffffUL));
  } else {
    snprintf(line, sizeof line, "%s", fc_error_text(error));
  }
  Serial.println(line);
  Serial.print(us);
  Serial.println(" us");
  Serial.flush();
}

void loop() {}
