"""Makes a keystore like `ros2 security create_keystore` and `create_enclave`, by the command openssl, without pongsim.

The documents are those of sros2 for Humble with its default policy. The keys have its file mode, too: other users can
read them."""

import pathlib
import subprocess

HEAD = """<dds xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance"
 xsi:noNamespaceSchemaLocation="http://www.omg.org/spec/DDS-SECURITY/20170901/omg_shared_ca_%s.xsd">
"""
GOVERNANCE = HEAD % "governance" + """<domain_access_rules><domain_rule><domains><id>{domain}</id></domains>
<allow_unauthenticated_participants>false</allow_unauthenticated_participants>
<enable_join_access_control>true</enable_join_access_control>
<discovery_protection_kind>ENCRYPT</discovery_protection_kind>
<liveliness_protection_kind>ENCRYPT</liveliness_protection_kind>
<rtps_protection_kind>ENCRYPT</rtps_protection_kind>
<topic_access_rules><topic_rule><topic_expression>*</topic_expression>
<enable_discovery_protection>true</enable_discovery_protection>
<enable_liveliness_protection>true</enable_liveliness_protection>
<enable_read_access_control>true</enable_read_access_control>
<enable_write_access_control>true</enable_write_access_control>
<metadata_protection_kind>ENCRYPT</metadata_protection_kind>
<data_protection_kind>ENCRYPT</data_protection_kind></topic_rule></topic_access_rules>
</domain_rule></domain_access_rules></dds>
"""
TOPICS = "".join(f"<topic>{topic}</topic>" for topic in (
    "rq/*/_action/cancel_goalRequest", "rq/*/_action/get_resultRequest", "rq/*/_action/send_goalRequest", "rq/*Request",
    "rr/*/_action/cancel_goalReply", "rr/*/_action/get_resultReply", "rr/*/_action/send_goalReply", "rr/*Reply",
    "rt/*", "rt/*/_action/feedback", "rt/*/_action/status", "ros_discovery_info"))
PERMISSIONS = HEAD % "permissions" + """<permissions><grant name="{name}"><subject_name>CN={name}</subject_name>
<validity><not_before>2013-10-26T00:00:00</not_before><not_after>2037-10-26T22:45:30</not_after></validity>
<allow_rule><domains><id>{domain}</id></domains>
<publish><topics>{topics}</topics></publish><subscribe><topics>{topics}</topics></subscribe></allow_rule>
<default>DENY</default></grant></permissions></dds>
"""


def openssl(*words):
    done = subprocess.run(["openssl", *map(str, words)], capture_output=True, text=True)
    assert done.returncode == 0, (words, done.stderr)


def _key(path):
    openssl("genpkey", "-algorithm", "EC", "-pkeyopt", "ec_paramgen_curve:P-256", "-out", path)
    path.chmod(0o644)


def _sign(keystore, source):
    openssl("smime", "-sign", "-text", "-in", source, "-out", source.with_suffix(".p7s"),
            "-signer", keystore / "public/permissions_ca.cert.pem", "-inkey", keystore / "private/permissions_ca.key.pem")


def make_keystore(keystore, domain):
    for folder in ("public", "private", "enclaves"):
        (keystore / folder).mkdir(parents=True)
    _key(keystore / "private/ca.key.pem")
    openssl("req", "-x509", "-new", "-key", keystore / "private/ca.key.pem", "-subj", "/CN=sros2CA", "-days", "3650",
            "-out", keystore / "public/ca.cert.pem")
    for role in ("identity", "permissions"):
        (keystore / f"public/{role}_ca.cert.pem").symlink_to("ca.cert.pem")
        (keystore / f"private/{role}_ca.key.pem").symlink_to("ca.key.pem")
    governance = keystore / "enclaves/governance.xml"
    governance.write_text(GOVERNANCE.format(domain=domain))
    _sign(keystore, governance)


def make_enclave(keystore, name, domain):
    folder = keystore / "enclaves" / name[1:]
    folder.mkdir()
    _key(folder / "key.pem")
    request = folder / "request"
    openssl("req", "-new", "-key", folder / "key.pem", "-subj", "/CN=" + name.replace("/", "\\/"), "-out", request)
    openssl("x509", "-req", "-in", request, "-CA", keystore / "public/ca.cert.pem", "-CAkey",
            keystore / "private/ca.key.pem", "-set_serial", str(1 + len(list(folder.parent.iterdir()))), "-days", "3650",
            "-out", folder / "cert.pem")
    request.unlink()
    for role in ("identity", "permissions"):
        (folder / f"{role}_ca.cert.pem").symlink_to(f"../../public/{role}_ca.cert.pem")
    (folder / "governance.p7s").symlink_to("../governance.p7s")
    permissions = folder / "permissions.xml"
    permissions.write_text(PERMISSIONS.format(name=name, domain=domain, topics=TOPICS))
    _sign(keystore, permissions)


def close_keys(keystore):
    """Makes the keys readable by their owner only, as pongsim's error message advises."""
    for key in pathlib.Path(keystore).rglob("*.key.pem"):
        key.chmod(0o600)
    for key in pathlib.Path(keystore).rglob("key.pem"):
        key.chmod(0o600)
