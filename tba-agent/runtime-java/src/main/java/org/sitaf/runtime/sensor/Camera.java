package org.sitaf.runtime.sensor;

import java.nio.ByteBuffer;
import org.sitaf.runtime.Device;

/**
 * A camera, with images as in {@code sensor_msgs/Image}. Unlike other devices, each call reads it
 * from the simulator.
 */
public interface Camera extends Device {
  /** The image at the current step. */
  Image image();

  /**
   * An image, row by row from the top.
   *
   * @param encoding {@code rgb8}: bytes red, green, blue; {@code 32FC1}: metres, as little-endian
   *     floats
   */
  record Image(int width, int height, String encoding, ByteBuffer data) {
    /** Checks the size and makes the data read-only. */
    public Image {
      if (width < 1 || height < 1) {
        throw new IllegalArgumentException("an image of " + width + " x " + height + " pixels");
      }
      data = data.asReadOnlyBuffer();
    }

    /** The data, positioned at its beginning. */
    @Override
    public ByteBuffer data() {
      return data.duplicate();
    }
  }
}
