package org.sitaf.runtime.sensor;

import java.nio.ByteBuffer;
import org.sitaf.runtime.Device;

/**
 * A camera; shape of {@code sensor_msgs/Image}. Unlike all others it is read from the simulator at
 * each call.
 */
public interface Camera extends Device {
  /** The picture at the current step. */
  Image image();

  /**
   * A picture, row by row from the top.
   *
   * @param encoding {@code rgb8}: bytes red, green, blue; {@code 32FC1}: metres, as little-endian
   *     floats
   */
  record Image(int width, int height, String encoding, ByteBuffer data) {
    /** Checks the size, and keeps the data from being written to. */
    public Image {
      if (width < 1 || height < 1) {
        throw new IllegalArgumentException("a picture of " + width + " x " + height + " pixels");
      }
      data = data.asReadOnlyBuffer();
    }

    /** The data, to be read from its beginning. */
    @Override
    public ByteBuffer data() {
      return data.duplicate();
    }
  }
}
