import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpRequest.BodyPublishers;
import java.net.http.HttpResponse.BodyHandlers;
import java.security.MessageDigest;
import java.util.HexFormat;

/** The server's REST interface. */
final class Rest {
  private final HttpClient client = HttpClient.newBuilder().version(HttpClient.Version.HTTP_1_1).build();
  private final String root;
  private final String token;

  Rest(int port, String token) {
    this.root = "http://127.0.0.1:" + port;
    this.token = token;
  }

  byte[] get(String path) throws Exception {
    return send(request(path).GET());
  }

  byte[] put(String path, String type, byte[] body) throws Exception {
    return send(request(path).header("Content-Type", type).PUT(BodyPublishers.ofByteArray(body)));
  }

  JsonObject post(String path, String type, byte[] body) throws Exception {
    byte[] answer = send(request(path).header("Content-Type", type).POST(BodyPublishers.ofByteArray(body)));
    return JsonParser.parseString(new String(answer)).getAsJsonObject();
  }

  JsonObject post(String path, String json) throws Exception {
    return post(path, "application/json", json.getBytes());
  }

  private HttpRequest.Builder request(String path) {
    return HttpRequest.newBuilder(URI.create(root + path)).header("Authorization", "Bearer " + token);
  }

  private byte[] send(HttpRequest.Builder request) throws Exception {
    var answer = client.send(request.build(), BodyHandlers.ofByteArray());
    if (answer.statusCode() / 100 != 2) {
      throw new IllegalStateException(answer.statusCode() + ": " + new String(answer.body()));
    }
    return answer.body();
  }

  static String sha256(byte[] content) {
    try {
      return HexFormat.of().formatHex(MessageDigest.getInstance("SHA-256").digest(content));
    } catch (java.security.NoSuchAlgorithmException e) {
      throw new IllegalStateException(e);
    }
  }
}
