package org.sitaf.server.story;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.util.Base64;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.StreamSupport;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sitaf.server.support.Activities;
import org.sitaf.server.support.Api;
import org.sitaf.server.support.ServerTest;
import tools.jackson.databind.JsonNode;

/** Activities that begin with a proposal of the server. */
@Tag("slow")
class ProposalStoryTest extends ServerTest {
  private static final String ZIP = "application/zip";
  private static final String PROPOSALS = "/api/v1/activity-proposals?name=begun";
  private static final byte[] NOTHING = {};
  private static final String NODE =
      """
      import rclpy
      from rclpy.node import Node
      from own_msgs.msg import Number

      class Follower(Node):
          def __init__(self):
              super().__init__('follower')
              self.out = self.create_publisher(Number, '/robot/speed', 10)
              self.create_subscription(Number, '/distance', print, 10)
              self.create_service(Number, self.name, print)
      """;

  private static byte[] zip(Map<String, String> files) {
    Map<String, byte[]> contents = new HashMap<>();
    files.forEach((path, text) -> contents.put(path, text.getBytes(StandardCharsets.UTF_8)));
    return Activities.zip(contents);
  }

  private static byte[] workspace(String setup) {
    return zip(
        Map.of(
            "ws/follower/package.xml", "<package><name>follower</name></package>",
            "ws/follower/setup.py", setup,
            "ws/follower/follower/node.py", NODE,
            "ws/follower/.git/config", "",
            "ws/own_msgs/package.xml", "<package><name>own_msgs</name></package>",
            "ws/own_msgs/msg/Number.msg", "float64 data\n"));
  }

  private JsonNode propose(String query, byte[] body) {
    return api.post(PROPOSALS + query, ZIP, body).expect(200).json();
  }

  private JsonNode create(JsonNode proposal) {
    byte[] archive = Base64.getDecoder().decode(proposal.get("archive").asString());
    return api.post("/api/v1/activities", ZIP, archive).expect(201).json();
  }

  private static List<String> paths(JsonNode proposal, boolean given) {
    return StreamSupport.stream(proposal.get("files").spliterator(), false)
        .filter(file -> file.get("given").asBoolean() == given)
        .map(file -> file.get("path").asString())
        .toList();
  }

  @Test
  void anInterfaceBecomesAnActivityWithCases() {
    byte[] files =
        zip(
            Map.of(
                "own_msgs/srv/Scale.srv",
                "Number factor\n---\nfloat64 scaled\n",
                "own_msgs/msg/Number.msg",
                "float64 data\n",
                "own_msgs/notes.txt",
                ""));
    int before = api.get("/api/v1/activities").json().get("total").asInt();

    JsonNode proposal = propose("&language=java&class=own.Scaler", files);

    assertThat(api.get("/api/v1/activities").json().get("total").asInt()).isEqualTo(before);
    assertThat(proposal.get("notes")).isEmpty();
    assertThat(paths(proposal, true))
        .containsExactly("own_msgs/msg/Number.msg", "own_msgs/srv/Scale.srv");
    assertThat(paths(proposal, false))
        .containsExactly("Scale.xml", "activity.yaml", "component/own/Scaler.java");
    JsonNode activity = create(proposal);
    assertThat(activity.get("name").asString()).isEqualTo("begun");
    assertThat(activity.get("componentClass").asString()).isEqualTo("own.Scaler");
    String models = "/api/v1/activities/" + activity.get("id").asString() + "/models/";
    assertThat(api.post(models + "Scale/suites", "{}").expect(201).json().get("total").asInt())
        .isPositive();
  }

  @Test
  void withoutFilesThereIsASmallInterface() {
    JsonNode activity = create(propose("", NOTHING));

    assertThat(activity.get("language").asString()).isEqualTo("python");
    assertThat(activity.get("models").get(0).get("method").asString()).isEqualTo("Step");
  }

  @Test
  void aPackageBecomesTheActivityOfItsNode() {
    JsonNode proposal = propose("&node=ws/follower", workspace(""));

    assertThat(paths(proposal, true))
        .containsExactly(
            "src/follower/follower/node.py",
            "src/follower/package.xml",
            "src/follower/setup.py",
            "src/own_msgs/msg/Number.msg");
    assertThat(paths(proposal, false)).containsExactly("Topics.xml", "activity.yaml");
    assertThat(proposal.get("notes").get(0).asString())
        .contains("creates 1 topics, services or actions whose names or types are no literals");
    JsonNode activity = create(proposal);
    assertThat(activity.get("componentClass").asString()).isEqualTo("follower.node:Follower");
  }

  @Test
  void severalNodesAreNamedSoThatOneCanBeChosen() {
    byte[] files = workspace("'a = follower.node:main', 'b = follower.node:other'");

    Api.Answer refused = api.post(PROPOSALS + "&node=ws/follower", ZIP, files).expect(422);

    assertThat(refused.json().get("nodes"))
        .extracting(JsonNode::asString)
        .containsExactly("follower.node:main", "follower.node:other");
    assertThat(refused.json().get("detail").asString()).contains("follower.node:other");
    JsonNode activity = create(propose("&node=ws/follower&class=follower.node:other", files));
    assertThat(activity.get("componentClass").asString()).isEqualTo("follower.node:other");
  }

  @ParameterizedTest
  @CsvSource({
    "422, '', 'contains several interface files; choose one as interface: a.idl, b.idl'",
    "422, '&interface=c.idl', 'is neither a given file nor an installed interface of ROS 2'",
    "422, '&interface=../a.idl', 'is neither a given file nor an installed interface of ROS 2'",
    "422, '&interface=notes.txt', 'is not an interface file: .xml (OPRoS), .idl'",
    "422, '&interface=a.idl&language=java&class=1a', component.class",
    "422, '&interface=a.idl&class=a%0Aworld:%20x.B', component.class",
    "400, '&interface=a.idl&language=rust', 'language must be one of java, cpp, python.'",
    "400, '&interface=a.idl&node=.', 'Give either interface or node, not both.'",
    "400, '&node=.&language=java', 'a ROS 2 node is written in python or cpp'",
    "422, '&node=.', 'name the folder of a ROS 2 package as node: follower'",
    "422, '&node=follower', 'has no source that uses rclpy or rclcpp'"
  })
  void whatCannotBeProposedIsExplained(int status, String query, String message) {
    byte[] files =
        zip(
            Map.of(
                "a.idl", "interface A { double f(in double x); };",
                "b.idl", "interface B { double f(in double x); };",
                "notes.txt", "",
                "follower/package.xml", "<package><name>follower</name></package>"));

    Api.Answer refused = api.post(PROPOSALS + query, ZIP, files).expect(status);

    assertThat(refused.json().get("detail").asString()).contains(message);
  }

  @Test
  void anArchiveThatIsNoneOrTooLargeIsRefused() {
    byte[] noZip = "no zip".getBytes(StandardCharsets.UTF_8);
    assertThat(api.post(PROPOSALS, ZIP, noZip).expect(422).text()).contains("ZIP archive");
    byte[] large = Activities.rawZip(List.of("a.idl"), new byte[8 << 20]);
    assertThat(api.post(PROPOSALS, ZIP, large).expect(422).text()).contains("unpacks to more than");
    api.post("/api/v1/activity-proposals", ZIP, NOTHING).expect(400);
  }

  @Test
  void aViewerMayNotPropose() {
    Api viewer = new Api(httpPort(), tokenOf("VIEWER"));
    assertThat(viewer.post(PROPOSALS, ZIP, NOTHING).status()).isEqualTo(403);
  }
}
